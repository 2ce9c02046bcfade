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

RC_GTEST_PROP(RcGenerators, ContactsKeepAnExactWitnessHoweverTheyShrink, (std::uint64_t seed)) {
  for (const Contact& made : family_of(gen::contact(), seed, 8)) {
    RC_ASSERT(check_truth(case_of(made)).has_value());
  }
}

RC_GTEST_PROP(RcGenerators, MutantsKeepAnExactWitnessHoweverTheyShrink, (std::uint64_t seed)) {
  for (const Contact& made : family_of(gen::mutant(gen::contact()), seed, 8)) {
    RC_ASSERT(check_truth(case_of(made)).has_value());
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
