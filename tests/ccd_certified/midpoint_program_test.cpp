#include "ccd/certified/midpoint_program.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace ccdfuzz::certified {
namespace {

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
