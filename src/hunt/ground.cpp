#include "hunt/ground.hpp"

namespace ccdfuzz {

std::optional<ContactClass> linear_class_of(const Query& query) {
  const auto count = [&](const Shape& shape) {
    return (query.patches[0].shape == shape) + (query.patches[1].shape == shape);
  };
  const int points = count(Shape::point()), edges = count(Shape::curve(1));
  if (points == 2) return ContactClass::kVV;
  if (edges == 2) return ContactClass::kEE;
  if (points == 1 && edges == 1) return ContactClass::kVE;
  if (points == 1 && count(Shape::triangle(1)) == 1) return ContactClass::kVF;
  return std::nullopt;
}

}  // namespace ccdfuzz
