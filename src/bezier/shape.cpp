#include "bezier/shape.hpp"

#include <fmt/format.h>

#include "base/verify.hpp"

namespace ccdfuzz {

std::string to_text(const Shape& shape) {
  switch (shape.kind) {
    case ShapeKind::kPoint:
      return "point";
    case ShapeKind::kTensor:
      return fmt::format("tensor({},{})", shape.n, shape.m);
    default:
      return fmt::format("{}({})", name_of(shape.kind), shape.n);
  }
}

void refuse_hull() {
  throw InternalError("a hull has no parameters");
}

}  // namespace ccdfuzz
