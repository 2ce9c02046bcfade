#include "hunt/draw.hpp"

#include <algorithm>

#include "base/verify.hpp"
#include "case/horizons.hpp"
#include "certify/checker/check_case.hpp"
#include "certify/oracle/oracle.hpp"
#include "hunt/uniform_case.hpp"
#include "properties/draw_linear.hpp"

namespace ccdfuzz {

namespace {

/// Generators prove what they say.
CheckedCase checked(Case made) {
  Result<CheckedCase> known = check_case(std::move(made));
  CCDFUZZ_VERIFY(known.has_value());
  return *std::move(known);
}

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

/// Families whose cases are rarely ordinary or never.
constexpr std::array kNotOrdinary = {
    Family::kAtStart,     Family::kResting,    Family::kSliding, Family::kFlatGrazing,
    Family::kMixedScales, Family::kDegenerate, Family::kSliver,  Family::kAnywhere};

struct NotPlain {
  Family family;
  Features needs;
};
constexpr std::array<NotPlain, kNotPlainFamilies.size()> kNotPlain = {
    {{Family::kWeighted, {.weights = true}},
     {Family::kRound, {.weights = true}},
     {Family::kApart, {.separation = true, .weights = true}},
     {Family::kTrimmed, {.trims = true}},
     {Family::kEnds, {.ends = true}},
     {Family::kSeparated, {.separation = true}}}};
static_assert(std::ranges::equal(kNotPlain, kNotPlainFamilies, {}, &NotPlain::family));

bool has_all(const Features& taken, const Features& needs) {
  return (taken.ends || !needs.ends) && (taken.separation || !needs.separation) &&
         (taken.weights || !needs.weights) && (taken.trims || !needs.trims) &&
         (taken.turns || !needs.turns) && (taken.angles || !needs.angles);
}

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
    sources = sources_of(contact);
    if (!sources.empty()) classes_.push_back(contact);
  }
}

void Draws::add_source(std::vector<Source>& sources, ContactClass contact,
                       const std::optional<ShapePair>& shapes, Family family,
                       Construction construction) const {
  if (ground_.ordinary && std::ranges::find(kNotOrdinary, family) != kNotOrdinary.end()) return;
  Source source;
  GeneratorOptions& options = source.options;
  options.contact = contact;
  options.construction = construction;
  options.family = family;
  options.shapes = shapes;
  options.bodies = ground_.body_kinds;
  options.plane = ground_.plane;
  options.seed = seed_;
  for (const CaseKind kind : kCaseKinds) {
    options.kind = kind;
    if (validate(options)) source.kinds.push_back(kind);
  }
  if (!source.kinds.empty()) sources.push_back(std::move(source));
}

void Draws::add_not_plain(std::vector<Source>& sources, ContactClass contact,
                          const std::optional<ShapePair>& shapes) const {
  for (const auto& [family, needs] : kNotPlain) {
    if (has_all(features_, needs)) add_source(sources, contact, shapes, family);
  }
}

std::vector<Draws::Source> Draws::linear_sources(size_t pair) const {
  std::vector<Source> sources(1);  // draw_linear_case, which makes all kinds
  if (!ground_.uniform) add_not_plain(sources, kLinearClasses[pair], kLinearPairs[pair]);
  return sources;
}

std::vector<Draws::Source> Draws::sources_of(ContactClass contact) const {
  std::vector<Source> sources;
  if (ground_.bodies) {
    add_source(sources, contact, std::nullopt, Family::kBodies);
    const Features needs = {.turns = !ground_.plane, .angles = ground_.plane};
    if (has_all(features_, needs)) add_source(sources, contact, std::nullopt, Family::kTurning);
    if (features_.spins) add_source(sources, contact, std::nullopt, Family::kSpinning);
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

Case Draws::generated(ContactClass contact, std::uint64_t index) const {
  const std::vector<Source>& around = sources_[static_cast<size_t>(contact)];
  const Source& source = around[index % around.size()];
  const std::uint64_t round = index / around.size();
  if (source.kinds.empty()) return draw_linear_case(contact, seed_, round);
  GeneratorOptions options = source.options;
  options.kind = source.kinds[round % source.kinds.size()];
  return generate(options, round).value;
}

Case Draws::drawn_case(ContactClass contact, std::uint64_t index) const {
  if (ground_.uniform) {
    Draw choices{Random::keyed({seed_, index, static_cast<std::uint64_t>(contact), 0x756e69})};
    return uniform_case(ground_, contact, choices);
  }
  return generated(contact, index);
}

std::vector<CheckedCase> Draws::at(ContactClass contact, std::uint64_t index) const {
  const CheckedCase made = checked(ground_.fitted(drawn_case(contact, index)));
  std::vector<CheckedCase> asked = are_by_shapes() ? std::vector{made} : forms_of(made);
  std::erase_if(asked, [&](const CheckedCase& c) { return !ground_.has(c.value()); });
  return asked;
}

}  // namespace ccdfuzz
