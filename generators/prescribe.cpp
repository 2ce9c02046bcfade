#include "generators/prescribe.hpp"

#include <algorithm>

namespace ccdfuzz {

std::array<Feature, 2> features_of(ContactClass contact) {
  using enum Feature;
  constexpr std::array<std::array<Feature, 2>, 6> features = {{{kFace, kFace},
                                                               {kEdge, kFace},
                                                               {kEdge, kEdge},
                                                               {kCorner, kFace},
                                                               {kCorner, kEdge},
                                                               {kCorner, kCorner}}};
  return features.at(static_cast<size_t>(contact));
}

ContactClass class_between(Feature a, Feature b) {
  using enum ContactClass;
  constexpr std::array<std::array<ContactClass, 3>, 3> kClasses = {
      {{kFF, kEF, kVF}, {kEF, kEE, kVE}, {kVF, kVE, kVV}}};
  return kClasses[static_cast<size_t>(a)][static_cast<size_t>(b)];
}

Barycentric prescribe_in_parent(Feature feature, Draw& draw) {
  const Dyadic zero, quarter(1, -2), half(1, -1), one(1);
  // A row for a face, an edge and a corner: two of the three, and the other one.
  const std::array<std::array<Dyadic, 2>, 3> shares = {
      {{quarter, half}, {half, zero}, {zero, one}}};
  const auto& [both, other] = shares[static_cast<size_t>(feature)];
  Barycentric x;
  x.fill(both);
  x[draw.below(3)] = other;
  return x;
}

Barycentric prescribe_anywhere(Feature feature, int bits, Draw& draw) {
  CCDFUZZ_ASSERT(2 <= bits && bits <= 20);
  const int steps = 1 << bits;
  std::array<int, 3> x{};
  const size_t corner = draw.below(3);
  if (feature == Feature::kFace) {
    // The first corner gets 1..62, and the others what is left, at least 1 each.
    x[corner] = static_cast<int>(draw.integer(1, steps - 2));
    x[(corner + 1) % 3] = static_cast<int>(draw.integer(1, steps - x[corner] - 1));
  } else if (feature == Feature::kEdge) {
    x[(corner + 1) % 3] = static_cast<int>(draw.integer(1, steps - 1));
  } else {
    x[(corner + 1) % 3] = steps;
  }
  x[(corner + 2) % 3] = steps - x[corner] - x[(corner + 1) % 3];
  return {Dyadic(x[0], -bits), Dyadic(x[1], -bits), Dyadic(x[2], -bits)};
}

Feature feature_at(const Barycentric& x) {
  switch (std::count(x.begin(), x.end(), Dyadic())) {
    case 0:
      return Feature::kFace;
    case 1:
      return Feature::kEdge;
    default:
      return Feature::kCorner;
  }
}

}  // namespace ccdfuzz
