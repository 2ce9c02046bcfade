#include "certify/oracle/decide_bodies.hpp"

#include <algorithm>
#include <optional>

#include "base/time_limit.hpp"
#include "base/verify.hpp"
#include "bezier/exact_patch.hpp"
#include "case/mesh.hpp"
#include "ccd/nearest_points.hpp"
#include "certify/oracle/decide_turning.hpp"
#include "certify/oracle/rational_roots.hpp"
#include "numeric/products.hpp"

namespace ccdfuzz {

namespace {

/// x > 0 rounded down, if it is long.
Rational shortened(const Rational& x) {
  if (bits_of(x.get_num()) + bits_of(x.get_den()) <= 4 * kTimeBits) return x;
  return rounded_down(x, power_below(x) * power_of_two(1 - kTimeBits));
}

class DecidingBodies {
 public:
  explicit DecidingBodies(const Query& query) : t_max_(exact(query.t_max)) {
    const auto a = exact_patch<Rational>(query.patches[0]);
    const auto b = exact_patch<Rational>(query.patches[1]);
    points_ = {a.positions, b.positions};
    velocity_ = b.velocities[0] - a.velocities[0];
    reach_ = exact(query.separation) + a.radius + b.radius;
  }

  Decision run() {
    try {
      if (!misses()) approach();
    } catch (const OutOfTime&) {
      out_.note = kOutOfTime;
    }
    return std::move(out_);
  }

 private:
  using Found = NearestPoints::Found;

  Points<Rational> moved(const Rational& t) const {
    Points<Rational> at = points_[1];
    for (Vec3<Rational>& p : at) p += t * velocity_;
    return at;
  }

  const Found& nearest_at(const Rational& t) {
    ++out_.pops;
    TimeLimit::stop_if_late();
    return nearest_(points_[0], moved(t));
  }

  bool is_contact(const Found& found) const { return found.squared <= reach_ * reach_; }

  void say_clear(const Rational& until, const Vec3<Rational>& normal, bool closed) {
    out_.truth.clearance = BodyClearance{until, normal, closed};
  }

  void say_contact(const Rational& t, const Found& found) {
    out_.truth.witness = Witness{t, {}, found.weights};
  }

  /// Otherwise a contact is known, by which the first has come.
  bool misses() {
    const size_t count = points_[1].size();
    Points<Rational> swept = points_[1];
    for (Vec3<Rational>& p : moved(t_max_)) swept.push_back(std::move(p));
    NearestPoints nearest;
    Found found = nearest(points_[0], swept);
    if (!is_contact(found)) {
      say_clear(t_max_, found.way, true);
      return true;
    }
    std::vector<Rational>& weights = found.weights[1];
    Rational moved_part = 0;
    for (size_t i = 0; i < count; ++i) {
      moved_part += weights[i + count];
      weights[i] += weights[i + count];
    }
    weights.resize(count);
    late_ = t_max_ * moved_part;
    late_found_ = std::move(found);
    return false;
  }

  void approach() {
    Rational t = 0;
    Found at = nearest_at(t);
    if (is_contact(at)) return say_contact(t, at);
    for (;;) {
      if (touches_at_rational_time(t, at)) return;
      const Rational speed = dot(at.way, velocity_);
      CCDFUZZ_VERIFY(speed < 0);  // as a contact comes
      const Rational ahead = (at.squared - reach_ * root_above(at.squared)) / -speed;
      const Rational next = t + ahead;
      if (ahead > 0) say_clear(next, at.way, false);
      const Found found = nearest_at(next);
      if (is_contact(found)) return say_contact(next, found);
      if (ahead <= next * power_of_two(-kBracketBits - 4)) return enclose(next);
      t = shortened(next);
      at = t == next ? found : nearest_at(t);
    }
  }

  /// Whether the first contact is where the way at t, as it changes there, is as long as the reach,
  /// and that is at a rational time.
  bool touches_at_rational_time(const Rational& t, const Found& at) {
    const Vec3<Rational> rate = nearest_.rate_of_way(velocity_);
    const Rational square = dot(rate, rate), half = dot(rate, at.way);
    const auto root = rational_root(half * half - square * (at.squared - reach_ * reach_));
    if (reach_ == 0 || !root || square == 0) return false;
    const Rational touch = t + (-half - *root) / square;
    if (touch <= t) return false;
    NearestPoints nearest = nearest_;
    const Found found = nearest(points_[0], moved(touch));
    if (found.squared != reach_ * reach_ || dot(found.way, velocity_) >= 0) return false;
    say_clear(touch, found.way, false);
    say_contact(touch, found);
    return true;
  }

  /// The first contact comes soon after t.
  void enclose(Rational t) {
    for (int bits = kBracketBits + 12; bits >= kBracketBits; bits -= 4) {
      const Rational later = shortened(t * (1 + power_of_two(-bits)));
      if (later >= late_) break;
      const Found found = nearest_at(later);
      if (is_contact(found)) return say_contact(later, found);
      t = later;
    }
    while (late_ - t > late_ * power_of_two(-kBracketBits)) {
      const Rational middle = shortened((t + late_) / 2);
      const Found& found = nearest_at(middle);
      if (is_contact(found)) {
        late_ = middle;
        late_found_ = found;
      } else {
        // The way keeps them apart before it, too, where they approach along it.
        if (dot(found.way, velocity_) <= 0) say_clear(middle, found.way, false);
        t = middle;
      }
    }
    say_contact(late_, late_found_);
  }

  const Rational t_max_;
  std::array<Points<Rational>, 2> points_;
  Vec3<Rational> velocity_;  ///< patch 2 relative to patch 1
  Rational reach_;
  NearestPoints nearest_;
  Rational late_;  ///< the time of a contact, and its points
  Found late_found_;
  Decision out_;
};

/// The least over the faces of a mesh that are there.
Decision decide_mesh(const Query& query) {
  const size_t side = mesh_side(query);
  Decision out;
  MeshClearance clear{exact(query.t_max), {}, true};
  bool are_clear = true;
  std::optional<Witness>& first = out.truth.witness;
  for (const size_t face : faces_there(query)) {
    const Query part = of_face(query, face);
    Decision found = DecidingBodies(part).run();
    out.pops += found.pops;
    if (!found.note.empty()) out.note = found.note;
    if (const auto& clearance = found.truth.clearance) {
      const auto& [until, normal, closed] = std::get<BodyClearance>(*clearance);
      clear.normals.push_back(normal);
      clear.until = std::min(clear.until, until);
      clear.closed = clear.closed && closed;
    } else {
      are_clear = false;
    }
    std::optional<Witness>& witness = found.truth.witness;
    if (!witness || (first && first->t <= witness->t)) continue;
    std::vector<Rational> weights(query.patches[side].positions.size());
    for (size_t i = 0; i < 3; ++i) {
      const int corner = query.patches[side].faces[face][i];
      weights[static_cast<size_t>(corner)] = witness->weights[side][i];
    }
    witness->weights[side] = std::move(weights);
    first = std::move(witness);
  }
  if (are_clear) out.truth.clearance = std::move(clear);
  return out;
}

}  // namespace

Decision decide_bodies(const Query& query, const OracleOptions& options) {
  if (!has_mesh(query) && has_turns(query)) return decide_turning(query, options);
  Decision out = has_mesh(query) ? decide_mesh(query) : DecidingBodies(query).run();
  std::optional<Witness>& witness = out.truth.witness;
  if (options.known && witness && options.known->t < witness->t) witness = options.known;
  conclude(query, out.truth);
  return out;
}

}  // namespace ccdfuzz
