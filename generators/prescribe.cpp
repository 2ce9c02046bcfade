#include "generators/prescribe.hpp"

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

}  // namespace ccdfuzz
