#include "case/mesh.hpp"
#include "finds/simplify.hpp"

namespace ccdfuzz {

namespace {

/// Without a face, and the points that only this one had; or with two sides.
void offer_faces(const Contact& q, const Offer& offer) {
  for (const size_t s : {0, 1}) {
    const MovingPatch<double>& now = q.query.patches[s];
    for (size_t f = now.faces.size(); f-- > 0 && now.faces.size() > 1;) {
      offer_changed(q, offer, [&](Query& next) {
        MovingPatch<double>& mesh = next.patches[s];
        mesh.faces.erase(mesh.faces.begin() + static_cast<long>(f));
        drop_unused_points(mesh);
      });
    }
    offer_changed(q, offer, [&](Query& next) { next.patches[s].one_sided = false; });
  }
}

/// Without a point.
void offer_points(const Contact& q, const Offer& offer) {
  for (const size_t s : {0, 1}) {
    const Points<double>& now = q.query.patches[s].positions;
    for (size_t i = now.size(); i-- > 0 && now.size() > 1;) {
      offer_changed(q, offer, [&](Query& next) { drop_point(next.patches[s], i); });
    }
  }
}

/// Without a turn, or about a simple point; a spin about one axis.
void offer_turns(const Contact& q, const Offer& offer) {
  for (const size_t s : {0, 1}) {
    if (!q.query.patches[s].turn) continue;
    if (offer_changed(q, offer, [&](Query& next) { next.patches[s].turn.reset(); })) continue;
    offer_changed(q, offer, [&](Query& next) { next.patches[s].turn->centre = {0, 0, 0}; });
    for (size_t k = 0; k < 3 && q.query.patches[s].turn->is_spin(); ++k) {
      offer_changed(q, offer, [&](Query& next) {
        std::vector<double>& spin = next.patches[s].turn->spin;
        const double kept = spin[k];
        spin.assign(3, 0);
        spin[k] = kept;
      });
    }
  }
}

/// One of them at rest, or a point of one at the origin.
void offer_resting(const Contact& q, const Offer& offer) {
  for (const size_t s : {0, 1}) {
    offer_changed(q, offer, [&](Query& next) {
      const Vec3<double> by = next.patches[s].velocities[0];
      for (MovingPatch<double>& hull : next.patches) hull.velocities[0] -= by;
    });
    for (const Vec3<double>& by : Points<double>(q.query.patches[s].positions)) {
      const bool taken = offer_changed(q, offer, [&](Query& next) {
        for (MovingPatch<double>& hull : next.patches) {
          for (Vec3<double>& p : hull.positions) p -= by;
          if (hull.turn) hull.turn->centre -= by;
        }
      });
      if (taken) break;
    }
  }
}

}  // namespace

void offer_simpler_bodies(const Contact& current, const Offer& offer) {
  offer_faces(current, offer);
  offer_points(current, offer);
  offer_turns(current, offer);
  offer_resting(current, offer);
}

}  // namespace ccdfuzz
