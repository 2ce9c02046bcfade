#include "ccd/certified/midpoint_program.hpp"
#include "bezier/exact_patch.hpp"

#include "bezier/cell.hpp"
#include "bezier/random_patch.hpp"
#include "bezier/restrict.hpp"

namespace ccdfuzz::certified {
namespace {

/// The program run in exact arithmetic.
std::vector<Vec3<Dyadic>> run(const MidpointProgram& program, Points<Dyadic> slots) {
  for (const MidpointProgram::Step step : program.steps) {
    Vec3<Dyadic> mean;
    for (int k = 0; k < 3; ++k) mean[k] = (slots[step.left][k] + slots[step.right][k]).scaled(-1);
    slots.push_back(mean);
  }
  return slots;
}

RC_GTEST_PROP(MidpointProgram, MakesTheSubPatchesOfTheChildCells, ()) {
  const Shape shape = *any_shape(5);
  const Points<Dyadic> points = any_points(shape);
  const MidpointProgram program(shape);
  const Points<Dyadic> slots = run(program, points);
  RC_ASSERT(static_cast<int>(program.children.size()) == shape.child_count());
  // Two levels, so that turned triangles are split too.
  for (int c = 0; c < shape.child_count(); ++c) {
    Points<Dyadic> child;
    for (const int place : program.children[c]) child.push_back(slots[place]);
    const Cell cell = Cell{}.child(shape, c);
    Points<Dyadic> expected(points.size());
    restrict_to<Dyadic>(shape, points, exact_corners<Dyadic>(cell.corners(shape)), expected);
    RC_ASSERT(child == expected);
    const Points<Dyadic> grand_slots = run(program, child);
    for (int g = 0; g < shape.child_count(); ++g) {
      const auto corners = cell.child(shape, g).corners(shape);
      restrict_to<Dyadic>(shape, points, exact_corners<Dyadic>(corners), expected);
      for (size_t i = 0; i < points.size(); ++i) {
        RC_ASSERT(grand_slots[program.children[g][i]] == expected[i]);
      }
    }
  }
}

TEST(MidpointProgram, CountsTheRoundingsBehindEverySlot) {
  for (int n = 1; n <= kMaxDegree; ++n) {
    for (const Shape& shape : {Shape::curve(n), Shape::triangle(n), Shape::tensor(n, 3)}) {
      const MidpointProgram program(shape);
      std::vector<int> behind(shape.control_count(), 0);
      for (const MidpointProgram::Step s : program.steps) {
        behind.push_back(std::max(behind[s.left], behind[s.right]) + 1);
      }
      EXPECT_EQ(*std::max_element(behind.begin(), behind.end()), program.roundings)
          << to_text(shape);
    }
  }
}

}  // namespace
}  // namespace ccdfuzz::certified
