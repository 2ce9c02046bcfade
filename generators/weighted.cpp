#include "generators/weighted.hpp"

#include <algorithm>
#include <cmath>

#include "bezier/exact_patch.hpp"
#include "generators/draw_patch.hpp"
#include "generators/exact_sum.hpp"
#include "generators/shaped/families.hpp"
#include "generators/shaped/features.hpp"
#include "generators/shaped/shaped_case.hpp"

namespace ccdfuzz {

namespace {

/// Places whose weighted sum is 0: pairs of control points go opposite ways, each by the weight of
/// the other.
Points<Dyadic> draw_balanced(Draw& draw, const std::vector<Dyadic>& weights) {
  Points<Dyadic> places(weights.size());
  for (std::size_t i = 0; i < weights.size(); ++i) {
    if (weights[i].sign() == 0) places[i] = draw.vector(4, -2);
  }
  for (std::size_t left = weights.size(); left > 1; --left) {
    const std::size_t i = draw.below(weights.size()), j = draw.below(weights.size());
    if (i == j || weights[i].sign() == 0 || weights[j].sign() == 0) continue;
    const long unit = std::max(top_of(weights[i]), top_of(weights[j]));
    const Vec3<Dyadic> way = draw.vector(3, -1);
    places[i] += way * weights[j].scaled(-unit);
    places[j] -= way * weights[i].scaled(-unit);
  }
  return places;
}

}  // namespace

bool add_exactly(double& x, const Dyadic& by) {
  if (const std::optional<double> step = by.to_double_exactly()) {
    double moved = x;
    if (!add_exactly(moved, *step)) return false;
    x = moved;
    return true;
  }
  const std::optional<double> sum = (Dyadic::exact(x) + by).to_double_exactly();
  if (sum) x = *sum;
  return sum.has_value();
}

bool add_exactly(Vec3<double>& x, const Vec3<Dyadic>& by) {
  Vec3<double> sum = x;
  for (int k = 0; k < 3; ++k) {
    if (!add_exactly(sum[k], by[k])) return false;
  }
  x = sum;
  return true;
}

bool add_exactly(Points<double>& points, const Vec3<Dyadic>& by) {
  return std::ranges::all_of(points, [&](Vec3<double>& p) { return add_exactly(p, by); });
}

std::optional<Vec3<Dyadic>> divided(const Vec3<Dyadic>& v, const Dyadic& by) {
  if (by == Dyadic(1)) return v;
  Vec3<Dyadic> out;
  for (int k = 0; k < 3; ++k) {
    if (v[k].mantissa() % by.mantissa() != 0) return std::nullopt;
    out[k] = Dyadic(Integer(v[k].mantissa() / by.mantissa()), v[k].exponent() - by.exponent());
  }
  return out;
}

bool pull_by_weights(Draw& draw, Contact& q, size_t side, int most) {
  MovingPatch<double>& patch = q.query.patches[side];
  std::vector<int> exponents(patch.positions.size());
  for (int& e : exponents) e = draw.integer(-most, most);
  if (exponents.size() == 1) return true;
  const auto contact = divided(q.point(side), q.weight(side));
  if (!contact) return false;
  if (patch.weights.empty()) patch.weights.assign(patch.positions.size(), 1);
  for (size_t i = 0; i < patch.weights.size(); ++i) {
    patch.weights[i] = std::ldexp(patch.weights[i], exponents[i]);
    const Vec3<Dyadic> start = exact_dyadic(patch.positions[i]);
    Vec3<Dyadic> move = exact_dyadic(patch.moves()[i]);
    if (patch.has_ends()) move -= start;
    const Vec3<Dyadic> way = start + move * q.t - *contact;
    const Vec3<Dyadic> by = way * Dyadic(1, -exponents[i]) - way;
    if (!add_exactly(patch.positions[i], by)) return false;
    if (patch.has_ends() && !add_exactly(patch.ends[i], by)) return false;
  }
  return are_weights(patch.weights);
}

void draw_free_weights(Draw& draw, Contact& q, size_t side) {
  MovingPatch<double>& patch = q.query.patches[side];
  if (patch.weights.empty()) return;  // of a point
  const std::vector<Dyadic> at_contact = q.weights(side);
  const std::vector<double> weights = draw_patch_weights(draw, patch.weights.size());
  for (std::size_t i = 0; i < weights.size(); ++i) {
    if (at_contact[i].sign() == 0) patch.weights[i] = weights[i];
  }
}

std::optional<Contact> draw_balanced_contact(Draw& draw, const std::array<Shape, 2>& shapes,
                                             const std::array<Uv<Dyadic>, 2>& uv) {
  Contact q;
  q.t = draw.pick(std::array{Dyadic(0), Dyadic(1), Dyadic(Integer(1), -1), Dyadic(Integer(3), -2)});
  q.query.t_max = draw.coin() ? 1 : *q.t.to_double_exactly();
  q.uv = uv;
  for (std::size_t s = 0; s < 2; ++s) {
    MovingPatch<double>& patch = q.query.patches[s];
    patch.shape = shapes[s];
    const auto count = static_cast<std::size_t>(patch.shape.control_count());
    if (draw.choose(3) != 3) patch.weights = draw_patch_weights(draw, count);
    MovingPatch<Dyadic> exactly{patch.shape, draw_balanced(draw, q.weights(s)), {}};
    for (std::size_t i = 0; i < count; ++i) exactly.velocities.push_back(draw.vector(4, -2));
    exactly.positions = exactly.at(-q.t);
    auto made = to_doubles(exactly);
    if (!made) return std::nullopt;
    made->weights = patch.weights;
    patch = *std::move(made);
  }
  return q;
}

/// Half of the positives and all negatives are regular one-sided cases whose control points are
/// pulled by powers of two. The plane that separates them before t* stays. Control points that have
/// no share in the contact then get a weight of any kind. The other positives are as
/// draw_balanced_contact makes them, and claim the contact alone.
Attempted weighted_case(const GeneratorOptions& options, Draw& draw) {
  std::optional<Contact> q;
  Case out;
  if (options.kind == CaseKind::kRP && draw.coin()) {
    std::array<Shape, 2> shapes;
    std::array<Uv<Dyadic>, 2> uv;
    for (std::size_t s = 0; s < 2; ++s) {
      const Feature feature = features_of(options.contact)[s];
      shapes[s] = options.shapes ? (*options.shapes)[s] : random_shape(feature, draw);
      uv[s] = point_on(feature, shapes[s], 2, draw);
    }
    q = draw_balanced_contact(draw, shapes, uv);
    if (q) out = case_of(*q);
  } else {
    CCDFUZZ_TRY(const Case regular, plain_case(Family::kRegular, options, draw));
    q = contact_of(regular);
    for (std::size_t s = 0; s < 2 && q; ++s) {
      if (!pull_by_weights(draw, *q, s, 3)) return tl::unexpected(Discard::kRoundTrip);
      draw_free_weights(draw, *q, s);
    }
    out = regular;
    if (q) out.query = q->query;
  }
  if (!q || !is_rational(q->query) || !is_valid(q->query)) {
    return tl::unexpected(Discard::kRoundTrip);
  }
  return as_asked(std::move(out), options);
}

/// True iff a patch has more than one control point.
bool have_weights(ContactClass, const ShapePair& shapes) {
  return shapes[0].kind != ShapeKind::kPoint || shapes[1].kind != ShapeKind::kPoint;
}

}  // namespace ccdfuzz
