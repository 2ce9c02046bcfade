// RapidCheck's generators are property-tested themselves: what they make, and what it shrinks to.
#include "certify/checker/check_truth.hpp"
#include "generators/rc/drawn.hpp"
#include "generators/rc/rapidcheck.hpp"
#include "rapidcheck.hpp"

namespace ccdfuzz {
namespace {

/// The value that a generator makes of a seed, and the first of what it shrinks to.
template <class T>
std::vector<T> family_of(const rc::Gen<T>& gen, std::uint64_t seed, std::size_t most) {
  const rc::Shrinkable<T> made = gen(rc::Random(seed), 100);
  std::vector<T> family = {made.value()};
  auto shrinks = made.shrinks();
  while (family.size() < most) {
    auto next = shrinks.next();
    if (!next) break;
    family.push_back(next->value());
  }
  return family;
}

/// Takes the first shrink that keeps, as RapidCheck does, until none does.
template <class T, class Keeps>
T least(const rc::Gen<T>& gen, std::uint64_t seed, const Keeps& keeps) {
  rc::Shrinkable<T> now = gen(rc::Random(seed), 100);
  auto shrinks = now.shrinks();
  while (auto next = shrinks.next()) {
    if (!keeps(next->value())) continue;
    now = *next;
    shrinks = now.shrinks();
  }
  return now.value();
}

bool anything(const Contact&) {
  return true;
}

RC_GTEST_PROP(RcGenerators, ContactsAndMutantsKeepAnExactWitnessHoweverTheyShrink,
              (std::uint64_t seed)) {
  for (const auto& gen : {gen::contact(), gen::mutant(gen::contact())}) {
    for (const Contact& made : family_of(gen, seed, 8)) {
      RC_ASSERT(check_truth(case_of(made)).has_value());
    }
  }
}

RC_GTEST_PROP(RcGenerators, CasesOfTheConstructionAreTrueHoweverTheyShrink, (std::uint64_t seed)) {
  for (const Case& made : family_of(gen::inverse(), seed, 3)) {
    RC_ASSERT(check_truth(made).has_value());
  }
}

RC_GTEST_PROP(RcGenerators, TheConstructionMakesWhatItsOptionsSay, (std::uint64_t seed)) {
  GeneratorOptions options;
  options.contact = *rc::gen::elementOf(kContactClasses);
  options.proof_pops = 1000;
  for (const Case& made : family_of(gen::inverse(options), seed, 10)) {
    const std::optional<Contact> contact = contact_of(made);
    RC_ASSERT(contact.has_value());
    RC_ASSERT(contact_class_of(*contact) == options.contact);
  }
}

/// Code for vertex-face and edge-edge queries that promises ordinary ones, all of few digits.
Domain mesh_code() {
  Domain promised;
  promised.pairs = linear_pairs();
  promised.scale = 7;
  promised.ordinary = true;
  return promised;
}

RC_GTEST_PROP(RcGenerators, ContactsAndMutantsArePromisedHoweverTheyShrink, (std::uint64_t seed)) {
  Domain promised = mesh_code();
  promised.binary32 = seed % 2 == 0;
  const auto contacts = gen::contact({.off_grid = promised.binary32}, promised);
  for (const auto& gen : {contacts, gen::mutant(contacts, promised)}) {
    for (const Contact& made : family_of(gen, seed, 4)) {
      RC_ASSERT(promised.order_of(made.query) == std::optional(false));
      RC_ASSERT(promised.broken_by(case_of(made)) == "");
    }
  }
}

TEST(RcGenerators, MutantsThatArePromisedAreMostlyOthers) {
  const Domain promised = mesh_code();
  int others = 0;
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    const Contact of = gen::contact({}, promised)(rc::Random(seed), 100).value();
    const auto mutants = gen::mutant(rc::gen::just(of), promised);
    others += mutants(rc::Random(seed), 100).value().query == of.query ? 0 : 1;
  }
  EXPECT_GT(others, 50);
}

TEST(RcGenerators, ShapesHaveEachOfTheirClassesOften) {
  ContactRange edges;
  edges.shapes = {Shape::curve(1), Shape::curve(1)};
  int found = 0;
  constexpr int kTries = 200, kClasses = 3;  // EE, VE, VV
  for (std::uint64_t seed = 0; seed < kTries; ++seed) {
    const Contact made = gen::contact(edges)(rc::Random(seed), 100).value();
    EXPECT_EQ(made.query.patches[0].shape, Shape::curve(1));
    EXPECT_EQ(made.query.patches[1].shape, Shape::curve(1));
    if (contact_class_of(made) == ContactClass::kEE) ++found;
  }
  EXPECT_GT(found, kTries / kClasses / 2);
}

/// What is said of a wrong argument.
template <class Make>
std::string complaint_of(const Make& make) {
  try {
    make();
  } catch (const std::invalid_argument& e) {
    return e.what();
  }
  return "";
}

/// The same of a range or promise, by the generator or what it generates.
std::string refusal_of(const ContactRange& range, const Domain& promised = {}) {
  return complaint_of([&] { gen::contact(range, promised)(rc::Random(1), 100).value(); });
}

TEST(RcGenerators, RefuseRangesWithoutContacts) {
  EXPECT_EQ(refusal_of({.max_degree = 0}), "gen::contact: max_degree: 0 is not in [1, 8]");
  EXPECT_EQ(refusal_of({.max_degree = 9}), "gen::contact: max_degree: 9 is not in [1, 8]");
  EXPECT_EQ(refusal_of({.coordinate_bits = 41}),
            "gen::contact: coordinate_bits: 41 is not in [0, 40]");
  EXPECT_EQ(refusal_of({.lowest = 41}), "gen::contact: highest: 40 is not in [41, 1000]");
  EXPECT_EQ(refusal_of({.highest = 3000}), "gen::contact: highest: 3000 is not in [-40, 1000]");
  EXPECT_EQ(refusal_of({.lowest = -3000}), "gen::contact: lowest: -3000 is not in [-1000, 1000]");
  EXPECT_EQ(refusal_of({.shapes = {{Shape::hull(4), Shape::point()}}}),
            "gen::contact: shapes: hull(4) is no patch of degrees from 1 to 8");
}

TEST(RcGenerators, MakeContactsAtTheEndsOfTheRange) {
  for (const int scale : {-1000, 1000}) {
    const ContactRange range{.lowest = scale,
                             .highest = scale,
                             .max_degree = kMaxDegree,
                             .coordinate_bits = 40,
                             .off_grid = true,
                             .elsewhere = true};
    for (std::uint64_t seed = 0; seed < 3; ++seed) {
      EXPECT_TRUE(check_truth(case_of(gen::contact(range)(rc::Random(seed), 100).value())));
    }
  }
}

TEST(RcGenerators, RefusePromisesThatNoContactKeeps) {
  Domain promised = mesh_code();
  EXPECT_EQ(refusal_of({.lowest = 30, .highest = 30}, promised),
            "gen::contact: none of 2000 contacts of this range keeps to: within 2^±7, ordinary "
            "queries alone");
  promised.scale = 4;
  EXPECT_EQ(refusal_of({}, promised), "gen::contact: scale: 4 is not at least 5");
  Domain narrow;
  narrow.scale = 3;
  EXPECT_EQ(refusal_of({}, narrow), "gen::contact: scale: 3 is not at least 5");
  narrow.pairs = linear_pairs();
  EXPECT_EQ(refusal_of({}, narrow), "");
  narrow.scale = 2;
  EXPECT_EQ(refusal_of({}, narrow), "gen::contact: scale: 2 is not at least 3");
  promised.scale.reset();
  EXPECT_EQ(refusal_of({.shapes = {{Shape::point(), Shape::point()}}}, promised),
            "gen::contact: shapes: are given, and so are pairs that are promised");
  EXPECT_EQ(refusal_of({}, {.plane = true}), "gen::contact: plane: is of bodies alone");
  EXPECT_EQ(refusal_of({}, {.initial_overlap = true}),
            "gen::contact: initial_overlap: needs ordinary");
  promised.pairs[0][1].max_degree = 9;
  EXPECT_EQ(refusal_of({}, promised),
            "gen::contact: shapes: triangle(9) is no patch of degrees from 1 to 8");
}

TEST(RcGenerators, RefuseToMutateWhatIsNotPromised) {
  Domain promised;
  promised.pairs = linear_pairs();
  const auto mutants = gen::mutant(rc::gen::just(falling_point()), promised);
  EXPECT_EQ(complaint_of([&] { mutants(rc::Random(1), 100).value(); }),
            "gen::mutant: a contact of `of` is not promised: takes point and triangle(1), "
            "curve(1) and curve(1), in this order, and this is point and curve(1)");
}

TEST(RcGenerators, SayWhatIsWrongWithOptions) {
  GeneratorOptions options;
  options.proof_pops = 0;
  EXPECT_EQ(complaint_of([&] { gen::inverse(options); }),
            "gen::inverse: proof_pops: 0 is not at least 1");
  options.eps_t_exponent = 5;
  EXPECT_EQ(complaint_of([&] { gen::inverse(options); }),
            "gen::inverse: eps_t: 2^5 is not in [2^-40, 2^-1]");
  EXPECT_EQ(complaint_of([] { gen::method([](const MethodInfo&) { return false; }); }),
            "gen::method: the filter takes no method");
}

TEST(RcGenerators, ContactsComeAtTimesAndPlacesOnTheGridAndOff) {
  std::array<int, 2> times{}, places{};
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    const Contact made = rc::gen::arbitrary<Contact>()(rc::Random(seed), 100).value();
    ++times[made.t.mantissa() < 1 << 24 ? 0 : 1];  // a float has so many bits
    ++places[made.uv[0][0].exponent() >= -2 && made.uv[1][0].exponent() >= -2 ? 0 : 1];
  }
  for (const int found : {times[0], times[1], places[0], places[1]}) EXPECT_GE(found, 8);
}

TEST(RcGenerators, AContactShrinksToPointsAtRest) {
  const Contact made = least(gen::contact(), 7, anything);
  for (const MovingPatch<double>& patch : made.query.patches) {
    EXPECT_EQ(patch.shape, Shape::point());
    EXPECT_EQ(patch.velocities[0], Vec3<double>(0, 0, 0));
  }
}

TEST(RcGenerators, ShrinkingKeepsWhatFails) {
  const auto is_late_triangle = [](const Contact& c) {
    return c.query.patches[1].shape.kind == ShapeKind::kTriangle && c.t == Dyadic(3, -2);
  };
  std::uint64_t seed = 0;
  while (!is_late_triangle(gen::contact()(rc::Random(seed), 100).value())) ++seed;
  const Contact made = least(gen::contact(), seed, is_late_triangle);
  EXPECT_TRUE(is_late_triangle(made));
  EXPECT_EQ(made.query.patches[1].shape, Shape::triangle(1));
}

RC_GTEST_PROP(RcGenerators, MethodsCanBeMade, ()) {
  const auto claims = [](const MethodInfo& info) {
    return info.claims_no_false_negative && !info.spec.starts_with("plugin");
  };
  const std::string spec = *gen::method(claims);
  RC_ASSERT(make_method(spec).has_value());
  RC_ASSERT(method_info(spec)->claims_no_false_negative);
  RC_ASSERT(make_method(*gen::method()).has_value());
}

}  // namespace
}  // namespace ccdfuzz
