#include "hunt/uniform_case.hpp"

#include <cmath>

#include "certify/oracle/oracle.hpp"
#include "generators/bodies.hpp"

namespace ccdfuzz {

namespace {

/// A float between −2^exponent and 2^exponent.
double uniform(Draw& draw, int exponent) {
  constexpr int kBits = 23;
  constexpr std::int64_t kMost = 1 << kBits;
  return std::ldexp(static_cast<double>(draw.integer(-kMost, kMost)), exponent - kBits);
}

Vec3<double> uniform_vector(Draw& draw, int exponent) {
  const double x = uniform(draw, exponent), y = uniform(draw, exponent);
  return {x, y, uniform(draw, exponent)};
}

MovingPatch<double> uniform_body(const BodyKinds& kinds, Draw& draw) {
  constexpr std::uint32_t kMostPoints = 12;
  const BodyKind kind = kinds.empty() ? BodyKind() : kinds[draw.below(kinds.size())];
  const auto points =
      static_cast<int>(draw.integer(kind.least_points, std::min(kind.most_points, kMostPoints)));
  MovingPatch<double> body{Shape::hull(points), {}, {uniform_vector(draw, 2)}};
  const Vec3<double> middle = uniform_vector(draw, 1);
  for (int i = 0; i < points; ++i) body.positions.push_back(middle + uniform_vector(draw, 0));
  const bool is_round =
      kind.radius == RadiusRule::kPositive || (kind.radius == RadiusRule::kAny && draw.coin());
  if (is_round) body.radius = std::abs(uniform(draw, 0));
  return body;
}

}  // namespace

Case uniform_case(const HuntGround& ground, ContactClass contact, Draw& draw) {
  Case out;
  out.origin.contact = name_of(contact);
  for (size_t s = 0; s < 2; ++s) {
    MovingPatch<double>& patch = out.query.patches[s];
    if (ground.bodies) {
      patch = uniform_body(ground.body_kinds, draw);
      continue;
    }
    patch.shape = shapes_of_class(contact)[s];
    for (int i = 0; i < patch.shape.control_count(); ++i) {
      patch.positions.push_back(uniform_vector(draw, 0));
      patch.velocities.push_back(uniform_vector(draw, 1));
    }
  }
  out.query.t_max = 1;
  if (std::optional<Case> decided = ground.bodies ? case_of_bodies(out.query) : std::nullopt) {
    out = *std::move(decided);
  } else {
    out.truth = decide(out.query).truth;
  }
  out.origin.generator = "uniform";
  return out;
}

}  // namespace ccdfuzz
