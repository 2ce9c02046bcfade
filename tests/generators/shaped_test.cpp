// Contacts of patches of any shapes: what every family promises of each of its cases.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <set>

#include "certify/checker/check_case.hpp"
#include "files/case_json.hpp"
#include "generators/generate.hpp"
#include "generators/shaped/shaped_case.hpp"
#include "share.hpp"

namespace ccdfuzz {
namespace {

/// Calls check(options, index, case) on a few cases of all families that are made of any shapes.
template <class Check>
void for_each_shaped_case(std::uint64_t count, const Check& check) {
  for (const Family family : kFamilies) {
    for (const ContactClass contact : kContactClasses) {
      for (const CaseKind kind : {CaseKind::kRP, CaseKind::kRN}) {
        GeneratorOptions options{.contact = contact, .kind = kind, .family = family};
        if (!is_shaped(options) || !is_made(family, contact, kind)) continue;
        for (std::uint64_t index = 0; index < count; index += kOneIn) {
          SCOPED_TRACE(fmt::format("{} {} {} index {}", name_of(family), name_of(contact),
                                   name_of(kind), index));
          check(options, generate(options, index).value);
        }
      }
    }
  }
}

TEST(Shaped, TheCheckerAcceptsTheProofOfEveryCaseAndAllShapesAreDrawn) {
  std::set<std::string> shapes;
  for_each_shaped_case(12, [&](const GeneratorOptions& options, const Case& c) {
    if (c.truth.clearance || options.kind == CaseKind::kRN) {
      const Result<void> absent = check_absence(c);
      ASSERT_TRUE(absent) << absent.error().message() << '\n' << to_json(c);
    }
    for (const MovingPatch<double>& patch : c.query.patches) shapes.insert(to_text(patch.shape));
  });
  if (kOneIn > 1) return;  // of few cases, not every shape is among them
  for (int n = 1; n <= 5; ++n) EXPECT_TRUE(shapes.contains(to_text(Shape::triangle(n)))) << n;
  for (int n = 1; n <= 4; ++n) {
    for (int m = 1; m <= 4; ++m) EXPECT_TRUE(shapes.contains(to_text(Shape::tensor(n, m))));
  }
  EXPECT_TRUE(shapes.contains("point"));
  EXPECT_TRUE(shapes.contains("curve(1)"));
}

TEST(Shaped, ProvesThatNothingTouchesBeforeButWhereItSaysThatItDoesNot) {
  const std::set<Family> none = {Family::kAtStart, Family::kResting, Family::kSliding,
                                 Family::kFlatGrazing};
  for_each_shaped_case(3, [&](const GeneratorOptions& options, const Case& c) {
    if (options.kind != CaseKind::kRP || options.family == Family::kAnywhere) return;
    const bool some = options.family == Family::kArea ||
                      (options.family == Family::kSeveral && options.contact == ContactClass::kFF);
    const auto& until = c.truth.clear_until;
    EXPECT_TRUE(some || until.has_value() == !none.contains(options.family));
    EXPECT_EQ(until.value_or(c.truth.witness->t), c.truth.witness->t);
  });
}

}  // namespace
}  // namespace ccdfuzz
