#include "certify/checker/check_truth.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "files/case_json.hpp"
#include "files/check_file.hpp"
#include "properties/rising_triangle.hpp"
#include "scratch_folder.hpp"

namespace ccdfuzz {
namespace {

std::string refusal(const Case& c) {
  const auto checked = check_truth(c);
  return checked ? "accepted" : checked.error().message();
}

template <class Change>
std::string refusal_after(const Change& change) {
  Case c = rising_triangle();
  change(c);
  return refusal(c);
}

TEST(CheckTruth, RefusesAWitnessThatIsNone) {
  EXPECT_EQ(refusal_after([](Case& c) { c.truth.witness->t = Rational(-1, 2); }),
            "truth.witness.t: -1/2 is negative");
  EXPECT_EQ(refusal_after([](Case& c) { c.query.t_max = 0.25; }),
            "truth.witness.t: 1/2 is after t_max = 0.25");
  EXPECT_EQ(refusal_after([](Case& c) { c.truth.witness->t = Rational(1, 3); }),
            "truth.witness.uv: the patches do not touch there: coordinate z is 1/3 and 1/2");
  EXPECT_EQ(refusal_after([](Case& c) { c.truth.witness->uv[0][1] = Rational("1/3"); }),
            "truth.witness.uv: the patches do not touch there: coordinate y is 1/3 and 0");
  EXPECT_EQ(refusal_after([](Case& c) {
              c.truth.witness->uv[0] = {Rational(3, 4), Rational("1/2")};
            }),
            "truth.witness.uv: (3/4, 1/2) lies outside the domain of patches[0], triangle(1)");
  EXPECT_EQ(refusal_after([](Case& c) {
              c.truth.witness->uv[1] = {Rational(0), Rational(-1)};
            }),
            "truth.witness.uv: (0, -1) lies outside the domain of patches[1], triangle(1)");
  // One last bit off.
  EXPECT_EQ(
      refusal_after([](Case& c) { c.query.patches[1].positions[0][2] = std::nextafter(0.5, 1); }),
      "truth.witness.uv: the patches do not touch there: coordinate z is 1/2 and "
      "4503599627370497/9007199254740992");
}

TEST(CheckTruth, RefusesAContradiction) {
  EXPECT_EQ(refusal_after([](Case& c) { c.truth.witness.reset(); }),
            "truth.witness: missing, though collides is true");
  EXPECT_EQ(refusal_after([](Case& c) {
              c.truth.collides = false;
              c.truth.proof = "P";
            }),
            "truth.collides: false, but the witness proves a contact at t = 1/2 ≤ t_max");
  EXPECT_EQ(refusal_after([](Case& c) { c.truth.clear_until = Rational("500001/1000000"); }),
            "truth.clear_until: 500001/1000000, but the witness proves a contact at t = 1/2 before "
            "it");
  EXPECT_EQ(refusal_after([](Case& c) { c.truth.clear_until = Rational(-1); }),
            "truth.clear_until: -1 is negative");
}

TEST(CheckTruth, RefusesAnInvalidQuery) {
  EXPECT_EQ(refusal_after([](Case& c) { c.query.patches[0].positions.pop_back(); }),
            "patches[0].positions: has 2; triangle(1) needs 3");
}

TEST(ReadCheckedCases, NamesFileLineAndField) {
  const ScratchFolder folder;
  Case bad = rising_triangle();
  bad.truth.witness->t = Rational(1, 3);
  bad.truth.clear_until = Rational(1, 3);
  write_text(folder / "c.jsonl", to_json(rising_triangle()) + "\n" + to_json(bad) + "\n");
  CaseStream cases({folder / "c.jsonl"});
  EXPECT_TRUE(next_checked(cases).value());
  EXPECT_EQ(next_checked(cases).error().message(),
            folder /
                "c.jsonl:2: truth.witness.uv: the patches do not touch there: coordinate z is "
                "1/3 and 1/2");
  write_text(folder / "c.jsonl", to_json(rising_triangle()) + "\n");
  EXPECT_TRUE(read_checked_case(folder / "c.jsonl"));
}

}  // namespace
}  // namespace ccdfuzz
