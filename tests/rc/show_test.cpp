// What RapidCheck prints of a counterexample.
#include "files/case_json.hpp"
#include "generators/rc/rapidcheck.hpp"
#include "rapidcheck.hpp"

namespace ccdfuzz {
namespace {

TEST(Show, AContactReadsAsWhatItIs) {
  Case known = case_of(falling_point());
  known.origin.kind.clear();
  known.origin.generator.clear();
  EXPECT_EQ(rc::toString(falling_point()),
            "VE touch at t = 1: patch 1, and patch 2 at u = 1/2\n"
            "patch 1, point:\n"
            "  (0, 0, 1) + t (0, 0, -1)\n"
            "patch 2, curve(1):\n"
            "  (-1, 0, 0) + t (0, 0, 0)\n"
            "  (1, 0, 0) + t (0, 0, 0)\n"
            "asked up to t = 1\n"
            "as a case, for ccdfuzz query and trace:\n" +
                to_json(known) + '\n');
}

template <class T>
std::string shown_of(std::uint64_t seed) {
  return rc::toString(rc::gen::arbitrary<T>()(rc::Random(seed), 100).value());
}

RC_GTEST_PROP(Show, NothingIsAPlaceholder, (std::uint64_t seed)) {
  RC_ASSERT(shown_of<Shape>(seed).find("???") == std::string::npos);
  RC_ASSERT(shown_of<Query>(seed).find("???") == std::string::npos);
  RC_ASSERT(shown_of<Case>(seed).find("???") == std::string::npos);
  RC_ASSERT(shown_of<Contact>(seed).find("???") == std::string::npos);
}

TEST(Show, AnAnswerAndANamedValueAreShownByTheirNames) {
  EXPECT_EQ(rc::toString(Answer::hit(0.5)), "hit at 0.5");
  EXPECT_EQ(rc::toString(Answer::miss()), "miss");
  Answer undecided;
  undecided.note = "out of memory";
  EXPECT_EQ(rc::toString(undecided), "undecided: out of memory");
  EXPECT_EQ(rc::toString(Verdict::kHit), "hit");
  EXPECT_EQ(rc::toString(ContactClass::kVF), "VF");
  EXPECT_EQ(rc::toString(Outcome::kFalsePositive), "false_positive");
}

RC_GTEST_PROP(Show, TheLastLineIsTheCaseAlone, (const Case& made)) {
  std::string text = rc::toString(made);
  RC_ASSERT(text.back() == '\n');
  text.pop_back();
  const Result<Case> read = parse_case(text.substr(text.rfind('\n') + 1), "shown");
  RC_ASSERT(read.has_value());
  RC_ASSERT(*read == made);
}

}  // namespace
}  // namespace ccdfuzz
