#pragma once

#include <functional>

#include "base/result.hpp"
#include "bezier/cell.hpp"
#include "bezier/patch.hpp"
#include "case/query.hpp"
#include "generators/draw/draw.hpp"
#include "numeric/exact_scalars.hpp"

namespace ccdfuzz {

/// Any of the four shapes, of degree at most max_degree.
Shape draw_shape(Draw& choices, int max_degree);

/// A triangle or a tensor patch of degree at most max_degree.
Shape draw_surface(Draw& choices, int max_degree);

/// Three whole numbers from −most to most.
Vec3<double> draw_integers(Draw& choices, std::int64_t most);

/// Control points on the lattice of multiples of 2^exponent with |m| < 2^bits.
Points<Dyadic> draw_points(Draw& choices, const Shape& shape, int bits, long exponent);

/// A dyadic point of the shape's domain in steps of 2^-bits; corners and edges are not rare.
Uv<Dyadic> draw_uv(Draw& choices, const Shape& shape, int bits);
/// The same with parameters below 1, of a triangle folded at u + v = 1; ends are rare. The lowest
/// bit of a choice is the parameter's highest. So a shrunk choice is a parameter of few bits.
Uv<Dyadic> draw_fine_uv(Draw& choices, const Shape& shape, int bits);

/// A cell of this depth; below 1, all of the patch.
Cell draw_cell_at(Draw& choices, const Shape& shape, std::int64_t depth);
/// A cell of depth at most max_depth.
Cell draw_cell(Draw& choices, const Shape& shape, int max_depth);

/// Integer coordinates within 8 of 0 and speeds of less than 2, in any two shapes of degree at most
/// max_degree; of points if that is 0. t_max is 1.
Query draw_small_query(Draw& choices, int max_degree);

/// Any two shapes of degree at most max_degree, each coordinate as draw_number draws it. t_max
/// is 1.
Query draw_query(Draw& choices, int max_degree, const std::function<double(Draw&)>& draw_number);

/// Any finite numbers at all, in any two shapes of degree at most 2.
Query draw_any_query(Draw& choices);

/// Finite numbers that are hard to bring to one magnitude, in any two shapes of degree at most 2.
/// Along each axis they are all alike, all alike but for a few floats, on a lattice of any unit, or
/// any.
Query draw_extreme_query(Draw& choices);

/// The query with the ends that a sum of doubles gives in place of velocities, of one patch or
/// both, and t_max at most 1. nullopt if one is not finite.
std::optional<Query> with_drawn_ends(Query query, Draw& choices);

/// Weights of any of these kinds: powers of two, small integers, of many bits, one of 2^±40 among
/// ones. Also those of an exact quarter circle, and those of one by a rounded √½.
std::vector<double> draw_patch_weights(Draw& choices, std::size_t count);

/// For failure texts; a query as a case file.
std::string to_text(const Query& query);
std::string to_text(const Cell& cell);

}  // namespace ccdfuzz
