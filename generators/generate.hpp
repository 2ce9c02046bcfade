#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <numeric>
#include <optional>
#include <stdexcept>
#include <string_view>

#include "base/enum_names.hpp"
#include "case/body_kind.hpp"
#include "case/case.hpp"
#include "case/taxonomy.hpp"
#include "generators/draw/draw.hpp"

namespace ccdfuzz {

/// How the patches are made at the moment of contact.
enum class Construction : std::uint8_t {
  kPaper,     ///< Section 5: random patches that obey the contact's linear constraints, filtered
  kOneSided,  ///< each patch on its own side of a plane: nothing to filter, proven by that plane;
              ///< of any shapes
};

constexpr std::array<std::string_view, 2> names_of(Construction) {
  return {"paper", "one-sided"};
}
inline constexpr auto kConstructions = all_of(Construction{});

/// The family of the cases, beyond contact class and kind. Each has a row in shaped/families.cpp.
/// All but the first are stress families. Each has an exact witness, whatever the construction
/// asked for. It is made to bring out one weakness, or is a contact of another kind. Twins are
/// positives of quadratic triangles, and claim nothing of the time before the contact. The others
/// prove by a moving plane that nothing touches before t*, except where the row says otherwise. The
/// last ones are not of plain patches. They are of bodies, weights, surfaces of revolution, loops,
/// ends and separations, of bodies that turn or spin, and of a mesh.
enum class Family : std::uint8_t {
  kRegular,
  kFlatGrazing,
  kCommonVelocity,
  kScaled,
  kTwins,
  kInteriorTime,
  kAtStart,
  kResting,
  kSliding,
  kSharedEdge,
  kRuled,
  kSeveral,
  kArea,
  kDegenerate,
  kSliver,
  kHighCurvature,
  kMixedScales,
  kFarAway,
  kConcurrentLines,
  kAnywhere,
  kBodies,
  kWeighted,
  kRound,
  kApart,
  kTrimmed,
  kEnds,
  kSeparated,
  kTurning,
  kSpinning,
  kMesh,
  kMeshOneSided,
  kBodiesGrazing,
  kMeshGrazing,
  kMeshGrazingOneSided,
  kTurningGrazing,
  kSpinningGrazing,
};
/// Those of a mesh that has fronts alone.
constexpr bool is_one_sided(Family family) {
  return family == Family::kMeshOneSided || family == Family::kMeshGrazingOneSided;
}
constexpr bool is_of_a_mesh(Family family) {
  return family == Family::kMesh || family == Family::kMeshGrazing || is_one_sided(family);
}
/// Those of bodies whose first contact has no depth.
constexpr bool is_grazing(Family family) {
  return family >= Family::kBodiesGrazing;
}
/// Those of patches that move along each other, or would.
constexpr bool is_grazing(CaseKind kind) {
  return kind == CaseKind::kNHP || kind == CaseKind::kNMN;
}
/// Those of bodies.
constexpr bool is_of_bodies(Family family) {
  return family == Family::kBodies || family >= Family::kTurning;
}
template <Family kFirst, Family kLast>
constexpr auto families_between() {
  constexpr auto kBegin = static_cast<size_t>(kFirst), kEnd = static_cast<size_t>(kLast) + 1;
  std::array<Family, kEnd - kBegin> all{};
  for (size_t i = 0; i < all.size(); ++i) all[i] = static_cast<Family>(kBegin + i);
  return all;
}
/// Those of plain patches.
inline constexpr auto kFamilies = families_between<Family::kRegular, Family::kAnywhere>();
inline constexpr auto kAllFamilies = families_between<Family::kRegular, Family::kSpinningGrazing>();
/// Those of queries with weights, loops, ends or a separation.
constexpr bool is_not_plain(Family family) {
  return family > Family::kAnywhere && !is_of_bodies(family);
}
inline constexpr auto kNotPlainFamilies = [] {
  std::array<Family, std::ranges::count_if(kAllFamilies, is_not_plain)> all{};
  std::ranges::copy_if(kAllFamilies, all.begin(), is_not_plain);
  return all;
}();
constexpr const auto& all_of(Family) {
  return kAllFamilies;
}
std::string_view name_of(Family family);
/// In a few words, without a full stop.
std::string_view description_of(Family family);

/// True iff the family has cases of this class and kind, of some shapes.
bool is_made(Family family, ContactClass contact, CaseKind kind);

struct GeneratorOptions {
  ContactClass contact = ContactClass::kFF;
  CaseKind kind = CaseKind::kRP;
  Construction construction = Construction::kPaper;
  Family family = Family::kRegular;
  /// The shapes of patches 1 and 2; by default both are quadratic triangles up to kInteriorTime,
  /// and random in the others. Other shapes are made one-sided only.
  std::optional<std::array<Shape, 2>> shapes = {};
  /// The kinds of bodies of the families from bodies on that have them; empty: all.
  BodyKinds bodies = {};
  /// Whether bodies lie and move in the plane z = 0: those of all families but meshes.
  bool plane = false;
  /// Bodies of Family::kSpinning spin by so many radians at most in [0, 1]; up to kFastestSpin.
  double most_spin = 3;
  /// Whether bodies of Family::kBodies may have numbers that are no floats.
  bool binary64 = false;
  /// Whether these, and bodies against meshes, may touch at t = 0.
  bool at_start = false;
  /// Whether all of them do. Requires Family::kBodies and RP.
  bool initial_overlap = false;
  std::uint64_t seed = 0;
  /// No contact is proven up to t* − eps_T, eps_T = 2^eps_t_exponent, where an RN case also ends.
  /// By default 2^-20, and 2^-10 for what grazes, NHP and families: that is only about eps_T² apart
  /// then.
  std::optional<int> eps_t_exponent = {};
  /// Pops of a search in exact arithmetic (at least 1) that is to prove an absence of contact,
  /// where no moving plane does. Those that are not enough for are thrown away, and the next may be
  /// another case: part of what describes a data set.
  std::uint64_t proof_pops = 100'000;
};

/// Why a construction was thrown away and begun anew.
enum class Discard : std::uint8_t {
  kStaticCheck,   ///< Appendix D: the patches penetrate at t* near the contact
  kFirstContact,  ///< Step V: no proof that nothing touches before t* − eps_T
  kRoundTrip,     ///< Section 5.4: a number is not a double
};
constexpr std::array<std::string_view, 3> names_of(Discard) {
  return {"static check", "first contact", "round trip"};
}
inline constexpr auto kDiscards = all_of(Discard{});

/// How often a construction was begun, and why some were thrown away.
struct DiscardCounts {
  std::uint64_t attempts = 0;
  std::array<std::uint64_t, kDiscards.size()> discarded{};

  std::uint64_t operator[](Discard reason) const { return discarded[static_cast<size_t>(reason)]; }
  std::uint64_t accepted() const {
    return attempts - std::accumulate(discarded.begin(), discarded.end(), std::uint64_t{0});
  }
  DiscardCounts& operator+=(const DiscardCounts& o) {
    attempts += o.attempts;
    for (size_t i = 0; i < discarded.size(); ++i) discarded[i] += o.discarded[i];
    return *this;
  }
  friend bool operator==(const DiscardCounts&, const DiscardCounts&) = default;
};

/// A case with exact truth, and what it cost.
struct Generated {
  Case value;
  DiscardCounts discards;
};

/// Errors: options outside what is generated, naming the option and its value.
Result<void> validate(const GeneratorOptions& options);

/// With this eps_T no construction is accepted: thousands in turn were refused.
struct NothingAccepted : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Case number `index` of the endless data set that `options` describe (Section 5, Steps I–VI). It
/// is two patches that touch at t* in a point of the given class, triangular quadratic ones by
/// default. RP: t_max = t*, truth: collides, with the exact witness. RN: the same patches with
/// t_max = t* − eps_T, truth: no contact. Both carry clear_until = t* − eps_T, proven. NHP
/// (near-hit): as RP, but at t* the patches move along each other within the contact plane. NMN
/// (near-miss): patches as of a near-hit, one of them moved away by 2^-20 to 2^-8 along one
/// coordinate. Truth: no contact up to t_max = t*, proven for all of it. The result depends on
/// (options, index) alone: not on the compiler, on threads or on other calls. Requires valid
/// options. Begins anew until a construction is accepted. Throws NothingAccepted.
Generated generate(const GeneratorOptions& options, std::uint64_t index);

/// A case of those options, whose seed is not used, of any choices: its origin has neither seed nor
/// index. Throws Discarded where bytes or stored numbers make none.
Generated generate(const GeneratorOptions& options, Draw& draw);

}  // namespace ccdfuzz
