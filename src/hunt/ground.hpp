#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "bezier/shape.hpp"
#include "case/case.hpp"
#include "case/taxonomy.hpp"
#include "method/domain.hpp"

namespace ccdfuzz {

using ShapePair = std::array<Shape, 2>;

/// The classes that linear queries come in, by their shapes: vertex-face, edge-edge, vertex-edge,
/// vertex-vertex.
inline constexpr std::array kLinearClasses = {ContactClass::kVF, ContactClass::kEE,
                                              ContactClass::kVE, ContactClass::kVV};
/// The shapes of these classes.
inline constexpr std::array<ShapePair, 4> kLinearPairs = {{{Shape::point(), Shape::triangle(1)},
                                                           {Shape::curve(1), Shape::curve(1)},
                                                           {Shape::point(), Shape::curve(1)},
                                                           {Shape::point(), Shape::point()}}};

/// Requires one of kLinearClasses.
const ShapePair& shapes_of_class(ContactClass contact);
/// The class of a query by its shapes, in either order: points, and curves and triangles of degree
/// 1. None of others, which are not linear.
std::optional<ContactClass> linear_class_of(const Query& query);
std::optional<ContactClass> linear_class_of(const Shape& a, const Shape& b);

/// Which queries a hunt is about; by default all of patches.
struct HuntGround : Domain {
  /// The shapes of patches 1 and 2.
  std::optional<ShapePair> shapes;
  /// Linear queries, of kLinearClasses alone, and not curved ones. Then shapes are not set.
  bool linear = false;
  /// Queries of bodies, and not of patches. Then neither shapes nor linear is set.
  bool bodies = false;
  /// Nothing but uniform_case, and no mutants: of bodies or linear patches.
  bool uniform = false;

  bool has(const Query& query) const;
  /// The same of a case, which is ordinary if only those count.
  bool has(const Case& value) const;
  /// Whether patches of these shapes are on it, in either order.
  bool has_shapes(const ShapePair& pair) const;

  /// Whether all patches that are drawn are of kLinearPairs, in either order.
  bool are_linear() const;
  /// The shapes to draw patches of; empty: any.
  std::vector<ShapePair> drawn_shapes() const;
  /// The case with its numbers on the ground: brought near the origin and to scale, small numbers
  /// to 0, each to the nearest float. Bodies are then given as floats (give_as_floats). A patch of
  /// which a weight is 0 loses its weights. Bodies are brought into the plane. Only bodies and
  /// linear patches are changed, for of these the truth of the changed query is decided exactly.
  Case fitted(Case value) const;
  /// One of its numbers: 0 for a small one, and the nearest float.
  double fitted(double x) const;
};

/// Makes all lengths of a query larger by 2^exponent, rounded.
void scale_lengths(Query& query, int exponent);

/// A query of bodies or linear patches as a case whose truth is decided, with its class. nullopt if
/// it is not decided.
std::optional<Case> decided_case(const Query& query);

/// What of a ground every one of the methods takes and promises to answer. Errors: nothing.
Result<HuntGround> narrowed(HuntGround ground, const std::vector<std::string>& methods);

}  // namespace ccdfuzz
