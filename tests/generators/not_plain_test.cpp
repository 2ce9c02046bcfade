// The families of loops, of ends and of separations.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "bezier/orientation.hpp"
#include "certify/oracle/oracle.hpp"
#include "files/case_json.hpp"
#include "generators/generate.hpp"

namespace ccdfuzz {
namespace {

/// Calls check on the first cases of each class.
template <class Check>
void for_each_case(Family family, CaseKind kind, std::uint64_t count, const Check& check) {
  for (const ContactClass contact : kContactClasses) {
    GeneratorOptions options{.contact = contact, .kind = kind, .family = family};
    for (std::uint64_t index = 0; index < count; ++index) check(generate(options, index).value);
  }
}

/// How far a point is from the nearest edge of the loops, in doubles.
double distance_to_loops(const Trim& trim, const Uv<double>& p) {
  double least = HUGE_VAL;
  for (const auto& loop : trim) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const auto &a = loop[i], &b = loop[(i + 1) % loop.size()];
      const double u = b[0] - a[0], v = b[1] - a[1];
      const double along =
          std::clamp(((p[0] - a[0]) * u + (p[1] - a[1]) * v) / (u * u + v * v), 0.0, 1.0);
      least = std::min(least, std::hypot(a[0] + along * u - p[0], a[1] + along * v - p[1]));
    }
  }
  return least;
}

TEST(Trimmed, ContactsAreInsideOnEdgesOnVerticesAndOneFloatInside) {
  int later = 0, inside = 0, on_edge = 0, on_slanted = 0, on_vertex = 0, float_inside = 0;
  for_each_case(Family::kTrimmed, CaseKind::kRP, 40, [&](const Case& c) {
    const Witness& witness = *c.truth.witness;
    if (witness.t > *c.truth.clear_until) {
      ++later;
      return;
    }
    for (std::size_t s = 0; s < 2; ++s) {
      const Trim& trim = c.query.patches[s].trim;
      if (trim.empty()) continue;
      const Uv<double> p = {witness.uv[s][0].get_d(), witness.uv[s][1].get_d()};
      bool is_on_loop = false;
      for (const auto& loop : trim) {
        for (std::size_t i = 0; i < loop.size(); ++i) {
          const auto &a = loop[i], &b = loop[(i + 1) % loop.size()];
          on_vertex += p == a;
          if (!is_on_segment(p, a, b)) continue;
          is_on_loop = true;
          ++on_edge;
          on_slanted += a[0] != b[0] && a[1] != b[1] && p != a && p != b;
        }
      }
      const double distance = distance_to_loops(trim, p);
      inside += distance > 0x1p-20;
      float_inside += !is_on_loop && distance < 0x1p-50;
    }
  });
  for (const int count : {later, inside, on_edge, on_slanted, on_vertex, float_inside}) {
    EXPECT_GT(count, 5);
  }
}

TEST(Trimmed, WholePatchesOfNegativesTouchAtTheEnd) {
  for_each_case(Family::kTrimmed, CaseKind::kRN, 3, [](const Case& c) {
    EXPECT_EQ(c.truth.collides, false);
    Query whole = c.query;
    for (MovingPatch<double>& patch : whole.patches) patch.trim.clear();
    const auto touches = decide(whole, {.max_pops = 3000, .max_tree_nodes = 100}).truth.collides;
    EXPECT_NE(touches, false) << to_json(c);
  });
}

TEST(Trimmed, OracleDecidesNegatives) {
  int decided = 0;
  for_each_case(Family::kTrimmed, CaseKind::kRN, 2, [&](const Case& c) {
    const auto found = decide(c.query, {.max_pops = 2000, .max_tree_nodes = 4000}).truth.collides;
    EXPECT_NE(found, true) << to_json(c);
    decided += found == false;
  });
  EXPECT_GT(decided, 6);
}

TEST(Ends, OfEachCaseSomeDifferenceToTheStartIsNoDouble) {
  for (const CaseKind kind : {CaseKind::kRP, CaseKind::kRN}) {
    for_each_case(Family::kEnds, kind, 3, [&](const Case& c) {
      EXPECT_TRUE(c.truth.clearance.has_value());
      EXPECT_FALSE(with_velocities(c.query)) << to_json(c);
      for (const MovingPatch<double>& patch : c.query.patches) EXPECT_TRUE(patch.has_ends());
    });
  }
}

TEST(Separated, EachCaseIsProvenUpToItsContact) {
  for_each_case(Family::kSeparated, CaseKind::kRP, 3, [](const Case& c) {
    EXPECT_GT(c.query.separation, 0);
    EXPECT_EQ(c.truth.clear_until, c.truth.witness->t) << to_json(c);
  });
}

}  // namespace
}  // namespace ccdfuzz
