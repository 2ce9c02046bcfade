#include "hunt/draw.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "certify/checker/check_case.hpp"
#include "certify/oracle/oracle.hpp"
#include "eval/horizons.hpp"
#include "generators/bodies.hpp"
#include "generators/similar.hpp"
#include "hunt/varied.hpp"
#include "method/plugin/feature_claims.hpp"
#include "properties/draw_linear.hpp"

namespace ccdfuzz {

namespace {

/// Linear case number `index` of such a class. It is degenerate in any of the ways that linear
/// codes fail on (draw_linear). Exact arithmetic decides its truth, and the checker accepts it.
/// Depends on the arguments alone.
Case draw_linear_case(ContactClass contact, std::uint64_t seed, std::uint64_t index) {
  for (std::uint64_t attempt = 0;; ++attempt) {
    Draw choices = Draw::mostly_small(Random::keyed(
        {seed, index, static_cast<std::uint64_t>(contact), attempt, 0x6c696e656172}));  // "linear"
    const Result<Query> query = draw_linear(choices);
    if (!query || linear_class_of(*query) != contact) continue;
    Case drawn;
    drawn.query = *query;
    drawn.truth = decide(*query).truth;
    if (!drawn.truth.collides) continue;
    drawn.origin.contact = name_of(contact);
    drawn.origin.kind = name_of(*drawn.truth.collides ? CaseKind::kRP : CaseKind::kRN);
    drawn.origin.generator = "linear";
    drawn.origin.seed = seed;
    drawn.origin.index = index;
    return drawn;
  }
}

/// A float between −2^exponent and 2^exponent.
double uniform(Draw& draw, int exponent) {
  constexpr int kBits = 23;
  constexpr std::int64_t kMost = 1 << kBits;
  return std::ldexp(static_cast<double>(draw.integer(-kMost, kMost)), exponent - kBits);
}

Vec3<double> uniform_vector(Draw& draw, int exponent) {
  const double x = uniform(draw, exponent), y = uniform(draw, exponent);
  return {x, y, uniform(draw, exponent)};
}

MovingPatch<double> uniform_body(const BodyKinds& kinds, Draw& draw) {
  constexpr std::uint32_t kMostPoints = 12;
  const BodyKind kind = kinds.empty() ? BodyKind() : kinds[draw.below(kinds.size())];
  const auto points =
      static_cast<int>(draw.integer(kind.least_points, std::min(kind.most_points, kMostPoints)));
  MovingPatch<double> body{Shape::hull(points), {}, {uniform_vector(draw, 2)}};
  const Vec3<double> middle = uniform_vector(draw, 1);
  for (int i = 0; i < points; ++i) body.positions.push_back(middle + uniform_vector(draw, 0));
  const bool is_round =
      kind.radius == RadiusRule::kPositive || (kind.radius == RadiusRule::kAny && draw.coin());
  if (is_round) body.radius = std::abs(uniform(draw, 0));
  return body;
}

/// A case that anybody would write first, to compare with: all numbers are uniform, and nothing is
/// planted. Bodies are of the ground's kinds. Their points are in a cube of edges 2 whose middle is
/// in one of edges 4, and their speeds are up to 4 along each axis. Linear patches of the class
/// have control points in a cube of edges 2, and speeds of up to 2. t_max is 1. The truth is
/// decided exactly.
Case uniform_case(const HuntGround& ground, ContactClass contact, Draw& draw) {
  Case out;
  out.origin.contact = name_of(contact);
  for (size_t s = 0; s < 2; ++s) {
    MovingPatch<double>& patch = out.query.patches[s];
    if (ground.bodies) {
      patch = uniform_body(ground.body_kinds, draw);
      continue;
    }
    patch.shape = shapes_of_class(contact)[s];
    for (int i = 0; i < patch.shape.control_count(); ++i) {
      patch.positions.push_back(uniform_vector(draw, 0));
      patch.velocities.push_back(uniform_vector(draw, 1));
    }
  }
  out.query.t_max = 1;
  if (std::optional<Case> decided = ground.bodies ? case_of_bodies(out.query) : std::nullopt) {
    out = *std::move(decided);
  } else {
    out.truth = decide(out.query).truth;
  }
  out.origin.generator = "uniform";
  return out;
}

/// Families of patches whose cases are rarely ordinary or never.
constexpr std::array kNotOrdinary = {
    Family::kAtStart,     Family::kResting,    Family::kSliding, Family::kFlatGrazing,
    Family::kMixedScales, Family::kDegenerate, Family::kSliver,  Family::kAnywhere};

/// A graze that hides a deep contact of a mesh is ordinary, no other is.
bool may_be_ordinary(Family family) {
  if (is_grazing(family)) return is_of_a_mesh(family);
  return std::ranges::find(kNotOrdinary, family) == kNotOrdinary.end();
}

/// A family, and what a method takes that is asked about it.
struct FamilyNeeds {
  Family family;
  Features needs;
};
/// Those of bodies, in the order in which draws go round.
constexpr std::array kOfBodies = {FamilyNeeds{Family::kBodies, {}},
                                  FamilyNeeds{Family::kTurning, {.turns = true}},
                                  FamilyNeeds{Family::kSpinning, {.spins = true}},
                                  FamilyNeeds{Family::kMesh, {.meshes = true}},
                                  FamilyNeeds{Family::kMeshGrazing, {.meshes = true}},
                                  FamilyNeeds{Family::kMeshOneSided, {.one_sided = true}},
                                  FamilyNeeds{Family::kMeshGrazingOneSided, {.one_sided = true}},
                                  FamilyNeeds{Family::kBodiesGrazing, {}},
                                  FamilyNeeds{Family::kTurningGrazing, {.turns = true}},
                                  FamilyNeeds{Family::kSpinningGrazing, {.spins = true}}};
constexpr bool have_one_row(const auto& rows, bool (*are_those)(Family)) {
  return std::ranges::all_of(kAllFamilies, [&](Family family) {
    return std::ranges::count(rows, family, &FamilyNeeds::family) == (are_those(family) ? 1 : 0);
  });
}
static_assert(have_one_row(kOfBodies, is_of_bodies), "a family has no row in kOfBodies");
constexpr std::array<FamilyNeeds, kNotPlainFamilies.size()> kNotPlain = {
    {{Family::kWeighted, {.weights = true}},
     {Family::kRound, {.weights = true}},
     {Family::kApart, {.separation = true, .weights = true}},
     {Family::kTrimmed, {.trims = true}},
     {Family::kEnds, {.ends = true}},
     {Family::kSeparated, {.separation = true}}}};
static_assert(have_one_row(kNotPlain, is_not_plain), "a family has no row in kNotPlain");

}  // namespace

Draws::Draws(std::uint64_t seed, const HuntGround& ground, const Features& features)
    : seed_(seed), ground_(ground), features_(features) {
  if (are_by_shapes()) {
    for (size_t i = 0; i < kLinearPairs.size(); ++i) {
      if (!ground_.has_shapes(kLinearPairs[i])) continue;
      classes_.push_back(kLinearClasses[i]);
      sources_[static_cast<size_t>(kLinearClasses[i])] = linear_sources(i);
    }
    return;
  }
  const bool are_deep = ground_.ordinary && ground_.are_linear();
  for (const ContactClass contact : kContactClasses) {
    // Contacts at an edge or a corner of linear patches are shallow.
    if (are_deep && contact != ContactClass::kEE && contact != ContactClass::kVF) continue;
    auto& sources = sources_[static_cast<size_t>(contact)];
    sources = ground_.bodies ? sources_of(contact) : spread(sources_of(contact));
    if (!sources.empty()) classes_.push_back(contact);
  }
}

/// The sources in an order in which any few that follow each other are of other shapes and
/// families.
std::vector<Draws::Source> Draws::spread(std::vector<Source> sources) {
  const size_t count = sources.size();
  // Near the golden ratio of the count.
  size_t step = std::max<size_t>(1, count * 5 / 8);
  while (std::gcd(step, count) != 1) ++step;
  std::vector<Source> out;
  for (size_t i = 0; i < count; ++i) out.push_back(std::move(sources[i * step % count]));
  return out;
}

void Draws::add_source(std::vector<Source>& sources, ContactClass contact,
                       const std::optional<ShapePair>& shapes, Family family,
                       Construction construction) const {
  if (ground_.ordinary && !may_be_ordinary(family)) return;
  Source source;
  GeneratorOptions& options = source.options;
  options.contact = contact;
  options.construction = construction;
  options.family = family;
  options.shapes = shapes;
  options.bodies = ground_.body_kinds;
  options.plane = ground_.plane && is_of_bodies(family);
  options.most_spin = ground_.most_spin.value_or(kFastestSpin);
  options.binary64 = !ground_.binary32;
  options.at_start = !ground_.ordinary;
  options.seed = seed_;
  for (const CaseKind kind : kCaseKinds) {
    options.kind = kind;
    if (validate(options)) source.kinds.push_back(kind);
  }
  if (!source.kinds.empty()) sources.push_back(std::move(source));
}

void Draws::add_not_plain(std::vector<Source>& sources, ContactClass contact,
                          const std::optional<ShapePair>& shapes) const {
  Features taken = features_;
  taken.separation = taken.separation || taken.kept_separation > 0;
  // Ends whose differences are no doubles are neither floats nor within a scale (varied).
  taken.ends = taken.ends && !ground_.binary32 && !ground_.scale;
  for (const auto& [family, needs] : kNotPlain) {
    if (has_all(taken, needs)) add_source(sources, contact, shapes, family);
  }
}

Case Draws::below_claim(Case value) const {
  const double kept = features_.kept_separation, separation = value.query.separation;
  if (kept == 0 || separation == 0) return value;
  int exponent = std::ilogb(kept) - std::ilogb(separation);
  if (std::ldexp(separation, exponent) >= kept) --exponent;
  return similar(value, {.space = exponent}).value_or(value);
}

std::vector<Draws::Source> Draws::linear_sources(size_t pair) const {
  std::vector<Source> sources(1);  // draw_linear_case, which makes all kinds
  if (!ground_.uniform) add_not_plain(sources, kLinearClasses[pair], kLinearPairs[pair]);
  return sources;
}

std::vector<Draws::Source> Draws::sources_of(ContactClass contact) const {
  std::vector<Source> sources;
  if (ground_.bodies) {
    for (auto [family, needs] : kOfBodies) {
      if (ground_.plane) needs.angles = std::exchange(needs.turns, false);
      if (takes_meshes_alone(features_) && !is_of_a_mesh(family)) continue;
      if (has_all(features_, needs)) add_source(sources, contact, std::nullopt, family);
    }
    const bool may_overlap = ground_.ordinary && ground_.initial_overlap;
    if (may_overlap && !takes_meshes_alone(features_) && !sources.empty()) {
      Source& overlapping = sources.emplace_back(sources.front());  // Family::kBodies
      overlapping.options.initial_overlap = true;
      overlapping.kinds = {CaseKind::kRP};
    }
    return sources;
  }
  const auto add_all = [&](const std::optional<ShapePair>& shapes) {
    for (const Construction construction : kConstructions) {
      add_source(sources, contact, shapes, Family::kRegular, construction);
    }
    for (const Family family : kFamilies) {
      if (family != Family::kRegular) add_source(sources, contact, shapes, family);
    }
    add_not_plain(sources, contact, shapes);
  };
  const std::vector<ShapePair> drawn = ground_.drawn_shapes();
  if (drawn.empty()) add_all(std::nullopt);
  for (const ShapePair& pair : drawn) add_all(pair);
  return sources;
}

Case Draws::drawn_case(ContactClass contact, std::uint64_t index) const {
  if (ground_.uniform) {
    Draw choices{Random::keyed({seed_, index, static_cast<std::uint64_t>(contact), 0x756e69})};
    return uniform_case(ground_, contact, choices);
  }
  const std::vector<Source>& around = sources_[static_cast<size_t>(contact)];
  const Source& source = around[index % around.size()];
  const std::uint64_t round = index / around.size();
  if (source.kinds.empty()) return draw_linear_case(contact, seed_, round);
  GeneratorOptions options = source.options;
  options.kind = source.kinds[round % source.kinds.size()];
  return below_claim(generate(options, round).value);
}

Case Draws::any_case(Draw& draw) const {
  const ContactClass contact = classes_[draw.below(classes_.size())];
  const std::vector<Source>& around = sources_[static_cast<size_t>(contact)];
  const Source& source = around[draw.below(around.size())];
  GeneratorOptions options = source.options;
  options.kind = source.kinds[draw.below(source.kinds.size())];
  return ground_.fitted(below_claim(generate(options, draw).value));
}

std::vector<CheckedCase> Draws::at(ContactClass contact, std::uint64_t index) const {
  const Case drawn = ground_.fitted(drawn_case(contact, index));
  Draw choices{Random::keyed(
      {seed_, index, static_cast<std::uint64_t>(contact), 0x766172696564})};  // "varied"
  const std::optional<Case> other = varied(drawn, ground_, features_, choices);
  const Case& known = other ? *other : drawn;
  const bool may_end_else = !ground_.uniform && choices.coin();
  const auto ended = may_end_else ? near_an_end(known, ground_, choices) : std::nullopt;
  // Generators prove what they say.
  const auto made = value_or_throw(check_case(ended ? *ended : known));
  std::vector<CheckedCase> asked = other || are_by_shapes() ? std::vector{made} : forms_of(made);
  if (ended) asked.back() = made;
  std::erase_if(asked, [&](const CheckedCase& c) { return !ground_.has(c.value()); });
  return asked;
}

}  // namespace ccdfuzz
