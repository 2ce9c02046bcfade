#include "hunt/draw_linear_case.hpp"

#include <optional>

#include "certify/oracle/oracle.hpp"
#include "properties/draw_linear.hpp"

namespace ccdfuzz {

namespace {

std::optional<ContactClass> linear_class_of(const Query& query) {
  const auto count = [&](ShapeKind kind) {
    return (query.patches[0].shape.kind == kind) + (query.patches[1].shape.kind == kind);
  };
  const int points = count(ShapeKind::kPoint), curves = count(ShapeKind::kCurve);
  if (points == 2) return ContactClass::kVV;
  if (curves == 2) return ContactClass::kEE;
  if (points == 1 && curves == 1) return ContactClass::kVE;
  if (points == 1 && count(ShapeKind::kTriangle) == 1) return ContactClass::kVF;
  return std::nullopt;
}

}  // namespace

Case draw_linear_case(ContactClass contact, std::uint64_t seed, std::uint64_t index) {
  for (std::uint64_t attempt = 0;; ++attempt) {
    RandomChoices choices(Random::keyed(
        {seed, index, static_cast<std::uint64_t>(contact), attempt, 0x6c696e656172}));  // "linear"
    const Result<Query> query = draw_linear(choices);
    if (!query || linear_class_of(*query) != contact) continue;
    Case drawn;
    drawn.query = *query;
    drawn.truth = decide(*query).truth;
    if (!drawn.truth.collides) continue;
    drawn.origin.contact = name_of(contact);
    drawn.origin.kind = name_of(*drawn.truth.collides ? CaseKind::kRP : CaseKind::kRN);
    drawn.origin.generator = "linear";
    drawn.origin.seed = seed;
    drawn.origin.index = index;
    return drawn;
  }
}

}  // namespace ccdfuzz
