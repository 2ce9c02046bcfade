#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "case/checked_case.hpp"
#include "generators/generate.hpp"
#include "hunt/ground.hpp"
#include "method/features.hpp"

namespace ccdfuzz {

/// The draws of a hunt for one method: an endless sequence for each contact class, which depends on
/// the seed, the ground and the features alone. It alternates between both constructions and all
/// stress families that have the class and the ground's shapes. Families of weights, loops, ends
/// and separations are among them where the features have these. A draw is a case with exact truth,
/// as it is put to the method (forms_of, varied, near_an_end). It is brought onto the ground where
/// that is possible (HuntGround::fitted). Else it is left out, so a draw may be empty.
class Draws {
 public:
  /// features: what the method takes.
  explicit Draws(std::uint64_t seed, const HuntGround& ground = {}, const Features& features = {});

  /// Those that have draws: of shapes, those whose features they have, so VV at least.
  const std::vector<ContactClass>& classes() const { return classes_; }
  /// Requires one of these classes.
  std::vector<CheckedCase> at(ContactClass contact, std::uint64_t index) const;
  /// A case of any class and source, fitted, of any choices. Requires that the ground is neither
  /// linear nor uniform. Throws Discarded.
  Case any_case(Draw& draw) const;

 private:
  /// What the draws of a class go round, with the kinds of cases that are made of it. Without
  /// kinds it is draw_linear_case.
  struct Source {
    GeneratorOptions options;
    std::vector<CaseKind> kinds;
  };

  /// Whether patches are drawn of kLinearPairs: uniform ones; or those that are degenerate in some
  /// way, none of them ordinary.
  bool are_by_shapes() const {
    return !ground_.bodies && (ground_.uniform || (ground_.linear && !ground_.ordinary));
  }
  Case drawn_case(ContactClass contact, std::uint64_t index) const;
  void add_source(std::vector<Source>& sources, ContactClass contact,
                  const std::optional<ShapePair>& shapes, Family family,
                  Construction construction = Construction::kOneSided) const;
  /// The families of what a query may have beyond plain patches, where features_ has that.
  void add_not_plain(std::vector<Source>& sources, ContactClass contact,
                     const std::optional<ShapePair>& shapes) const;
  /// A case with a separation in units of which it is just below the claim that keeps patches
  /// apart, if the method takes separations by that alone.
  Case below_claim(Case value) const;
  std::vector<Source> linear_sources(size_t pair) const;
  std::vector<Source> sources_of(ContactClass contact) const;
  static std::vector<Source> spread(std::vector<Source> sources);

  std::uint64_t seed_;
  HuntGround ground_;
  Features features_;
  std::vector<ContactClass> classes_;
  std::array<std::vector<Source>, kContactClasses.size()> sources_;
};

}  // namespace ccdfuzz
