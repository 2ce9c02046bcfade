#include "finds/minimise.hpp"

#include <cmath>

#include "case/mesh.hpp"
#include "case/scale.hpp"
#include "finds/content_address.hpp"
#include "finds/simplify.hpp"
#include "generators/bodies.hpp"

namespace ccdfuzz {

namespace {

class BodyMinimiser {
 public:
  BodyMinimiser(const Case& found, Outcome failure,
                const std::function<bool(const Case&)>& still_fails, const MinimiseOptions& options)
      : failure_(failure), still_fails_(still_fails), options_(options) {
    best_.value = found;
    are_floats_ = is_binary32(found.query);
    const std::optional<Case> decided =
        failure == Outcome::kError ? std::nullopt : case_of_bodies(found.query);
    if (decided) contact_ = decided->origin.contact;
  }

  Minimised run() {
    if (!is_failure(failure_)) return best_;
    for (bool goes_on = true; goes_on && !ended();) {
      const std::uint64_t before = taken_;
      drop_faces();
      drop_points();
      offer_turns();
      offer_resting();
      offer_numbers();
      goes_on = taken_ > before;
    }
    return best_;
  }

 private:
  bool ended() const { return best_.trials >= options_.max_trials || options_.stop(); }
  const Query& query() const { return best_.value.query; }

  /// Points and faces count first: a body of fewer is simpler to a reader.
  static auto rank_of_bodies(const Query& query) {
    size_t parts = 0;
    for (const MovingPatch<double>& body : query.patches) {
      parts += body.positions.size() + body.faces.size() + (body.one_sided ? 1 : 0);
    }
    return std::pair(parts, size_of(query));
  }

  template <class Change>
  bool offer(const Change& change) {
    Query next = query();
    change(next);
    if (ended() || !(rank_of_bodies(next) < rank_of_bodies(query())) || !is_valid(next)) {
      return false;
    }
    if (are_floats_ && !is_binary32(next)) return false;
    if (next.t_max == 0 && query().t_max > 0) return false;  // a cast that goes nowhere
    Case made{next, {}, {}};
    if (failure_ != Outcome::kError) {
      std::optional<Case> decided = case_of_bodies(next);
      if (!decided || *decided->truth.collides != is_false_negative(failure_)) return false;
      made = *std::move(decided);
    }
    if (made.origin.contact != contact_) return false;
    made.origin = best_.value.origin;
    made.asked = best_.value.asked;
    ++best_.trials;
    if (!still_fails_(made)) return false;
    best_.value = std::move(made);
    ++taken_;
    return true;
  }

  void drop_points() {
    for (size_t s = 0; s < 2; ++s) {
      for (size_t i = query().patches[s].positions.size(); i-- > 0;) {
        if (query().patches[s].positions.size() == 1) break;
        offer([&](Query& q) { drop_point(q.patches[s], i); });
      }
    }
  }

  /// Without a face, and the points that only this one had; or with two sides.
  void drop_faces() {
    for (const size_t s : {0, 1}) {
      for (size_t f = query().patches[s].faces.size();
           f-- > 0 && query().patches[s].faces.size() > 1;) {
        offer([&](Query& q) {
          MovingPatch<double>& mesh = q.patches[s];
          mesh.faces.erase(mesh.faces.begin() + static_cast<long>(f));
          drop_unused_points(mesh);
        });
      }
      if (query().patches[s].one_sided) offer([&](Query& q) { q.patches[s].one_sided = false; });
    }
  }

  /// Without a turn, or about a simple point.
  void offer_turns() {
    for (const size_t s : {0, 1}) {
      if (!query().patches[s].turn) continue;
      if (offer([&](Query& q) { q.patches[s].turn.reset(); })) continue;
      offer([&](Query& q) { q.patches[s].turn->centre = {0, 0, 0}; });
      // A spin about one axis. Its numbers are offered with all others.
      for (size_t k = 0; k < 3 && query().patches[s].turn->is_spin(); ++k) {
        offer([&](Query& q) {
          std::vector<double>& spin = q.patches[s].turn->spin;
          const double kept = spin[k];
          spin.assign(3, 0);
          spin[k] = kept;
        });
      }
    }
  }

  /// One of them at rest, or a point of one at the origin.
  void offer_resting() {
    for (const size_t s : {0, 1}) {
      offer([&](Query& q) {
        const Vec3<double> by = q.patches[s].velocities[0];
        for (MovingPatch<double>& hull : q.patches) hull.velocities[0] -= by;
      });
      for (const Vec3<double>& by : Points<double>(query().patches[s].positions)) {
        const bool taken = offer([&](Query& q) {
          for (MovingPatch<double>& hull : q.patches) {
            for (Vec3<double>& p : hull.positions) p -= by;
            if (hull.turn) hull.turn->centre -= by;
          }
        });
        if (taken) break;
      }
    }
  }

  void offer_numbers() {
    for (const int bits : {1, 2, 3, 5, 8, 12}) {
      const bool taken = offer([&](Query& q) {
        for_each_number(q, [&](double& x) { x = with_bits(x, bits, std::round); });
      });
      if (taken) break;
    }
    size_t count = 0;
    Query all = query();
    for_each_number(all, [&](double&) { ++count; });
    for (size_t i = 0; i < count; ++i) {
      for (const int bits : {0, 1, 2, 3, 5, 8, 12, 18}) {
        const bool taken = offer([&](Query& q) {
          size_t at = 0;
          for_each_number(q,
                          [&](double& x) { x = at++ == i ? with_bits(x, bits, std::round) : x; });
        });
        if (taken) break;
      }
    }
  }

  Outcome failure_;
  const std::function<bool(const Case&)>& still_fails_;
  const MinimiseOptions& options_;
  Minimised best_;
  bool are_floats_ = false;
  std::string contact_;  ///< its class, as case_of_bodies tells it
  std::uint64_t taken_ = 0;
};

}  // namespace

Minimised minimise_bodies(const Case& found, Outcome failure,
                          const std::function<bool(const Case&)>& still_fails,
                          const MinimiseOptions& options) {
  return BodyMinimiser(found, failure, still_fails, options).run();
}

}  // namespace ccdfuzz
