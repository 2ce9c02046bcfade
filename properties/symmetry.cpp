#include "properties/symmetry.hpp"

#include "bezier/exact_patch.hpp"
#include "fuzz/mutator/reshape.hpp"
#include "generators/draw_patch.hpp"
#include "generators/similar.hpp"

namespace ccdfuzz {

namespace {

template <class Change>
void change_coordinates(Case& value, const Change& change) {
  for (MovingPatch<double>& patch : value.query.patches) {
    for (Points<double>* points : {&patch.positions, &patch.velocities}) {
      for (Vec3<double>& p : *points) change(p);
    }
  }
}

bool reverse_time(Case& value) {
  const Dyadic end = Dyadic::exact(value.query.t_max);
  for (MovingPatch<double>& patch : value.query.patches) {
    const auto at_end = to_doubles(exact_patch<Dyadic>(patch).at(end));
    if (!at_end) return false;
    patch.positions = *at_end;
    for (Vec3<double>& v : patch.velocities) v = -v;
  }
  value.truth.witness->t = end.rational() - value.truth.witness->t;
  return true;
}

/// Both patches times the degrees that elevation divides by, lest it rounds.
bool elevate(Contact& q, size_t side) {
  const Shape shape = q.query.patches[side].shape;
  if (shape.kind == ShapeKind::kPoint) return true;
  const Dyadic factor((shape.n + 1) * (shape.m + 1));
  bool is_exact = true;
  for (MovingPatch<double>& patch : q.query.patches) {
    for_each_coordinate(patch, [&](double& x) {
      const auto product = (Dyadic::exact(x) * factor).to_double_exactly();
      is_exact = is_exact && product;
      x = product.value_or(x);
    });
  }
  return is_exact && elevate_patch(q, side, false) &&
         (shape.kind != ShapeKind::kTensor || elevate_patch(q, side, true));
}

/// Cut down to any of the children that hold the contact, up to three times.
bool cut(Contact& q, size_t side, Draw& choices) {
  if (q.query.patches[side].shape.kind == ShapeKind::kPoint) return true;
  for (std::int64_t depth = choices.integer(1, 3); depth > 0; --depth) {
    reparametrise_patch(q, side, choices.choose(4));
    if (!restrict_patch(q, side)) return false;
  }
  return true;
}

/// The case after a change of its contact. Nothing if the change is not exact.
template <class Change>
std::optional<Case> changed(Case value, const Change& change) {
  std::optional<Contact> q = contact_of(value);
  if (!q || !change(*q)) return std::nullopt;
  value.query = q->query;
  value.truth.witness = q->witness();
  return value;
}

}  // namespace

std::optional<Case> transformed(const Case& value, Symmetry symmetry, Draw& choices) {
  Case out = value;
  out.truth = Truth();
  out.truth.collides = true;
  out.truth.witness = value.truth.witness;
  out.expect.clear();
  const size_t side = choices.choose(1);
  switch (symmetry) {
    case Symmetry::kSwapPatches:
      std::swap(out.query.patches[0], out.query.patches[1]);
      std::swap(out.truth.witness->uv[0], out.truth.witness->uv[1]);
      break;
    case Symmetry::kReverseParameters:
      return changed(out, [&](Contact& q) {
        reparametrise_patch(q, side, choices.choose(4));
        return true;
      });
    case Symmetry::kPermuteAxes: {
      const bool odd = choices.coin();
      change_coordinates(out, [&](Vec3<double>& p) {
        p = odd ? Vec3<double>(p[1], p[0], p[2]) : Vec3<double>(p[1], p[2], p[0]);
      });
      break;
    }
    case Symmetry::kMirror: {
      const auto k = static_cast<int>(choices.choose(2));
      change_coordinates(out, [&](Vec3<double>& p) { p[k] = -p[k]; });
      break;
    }
    case Symmetry::kScale:
      return similar(out, {.space = choices.integer(-60, 60)});
    case Symmetry::kScaleTime:
      return similar(out, {.time = choices.integer(-60, 60)});
    case Symmetry::kTranslate:
      return similar(out, {.shift = draw_integers(choices, 256)});
    case Symmetry::kCommonVelocity:
      return similar(out, {.drift = draw_integers(choices, 256)});
    case Symmetry::kReverseTime:
      if (!reverse_time(out)) return std::nullopt;
      break;
    case Symmetry::kElevate:
      return changed(out, [&](Contact& q) { return elevate(q, side); });
    case Symmetry::kPart:
      return changed(out, [&](Contact& q) { return cut(q, side, choices); });
  }
  return out;
}

}  // namespace ccdfuzz
