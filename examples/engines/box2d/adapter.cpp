// Box2D v3: the time of impact of two shapes that do not turn, or with the option turns=1 of those
// that do, by b2TimeOfImpact.
#include <box2d/collision.h>

#include "../../plugins/adapter.hpp"

namespace ccd = adapter::ccd;

struct Box2d {
  explicit Box2d(const std::string& text) : options(text) {
    turns = options.number("turns", 0) != 0;
    options.check_all_known();
  }

  ccd::Description describe() const {
    ccd::Description d{"Box2D", ENGINE_VERSION};
    // Neither a contact at 0 nor one at the end.
    d.claims = CCDFUZZ_TAKES_BODIES | CCDFUZZ_BINARY32 | CCDFUZZ_ORDINARY | CCDFUZZ_PLANE;
    d.within = 7;
    d.pairs = {{{CCDFUZZ_HULL, CCDFUZZ_HULL}, {B2_MAX_POLYGON_VERTICES, B2_MAX_POLYGON_VERTICES}}};
    d.bodies = {{1, B2_MAX_POLYGON_VERTICES, CCDFUZZ_ANY_RADIUS}};
    d.promise =
        "with fixed rotations the time of impact function will not miss any collisions: "
        "https://github.com/erincatto/box2d/blob/v3.1.1/docs/collision.md#time-of-impact";
    // It stops where shapes overlap by its slop, 0.005, and a quarter of that is its tolerance.
    d.tolerance_kind = CCDFUZZ_TOLERANCE_SPACE;
    d.tolerance = 1.25 * 0.005;
    if (turns) {
      d.claims |= CCDFUZZ_TAKES_ANGLES;
      d.promise = "none of bodies that turn: its header says that it may miss collisions";
    }
    return d;
  }

  static b2Vec2 vector(const double (&x)[3], double factor = 1) {
    return {adapter::as_float(factor * x[0]), adapter::as_float(factor * x[1])};
  }

  static b2Rot rotation(const double* q) {
    return {adapter::of_unit(q, 2, 0), adapter::of_unit(q, 2, 1)};
  }

  static ccd::Answer answer(const ccd::Query& query) {
    b2TOIInput input{};
    const bool turned =
        query.raw.patches[0]->turn_count > 0 || query.raw.patches[1]->turn_count > 0;
    const double way = turned ? 1 : query.t_max();  // at fraction 1
    input.maxFraction = turned ? static_cast<float>(query.t_max()) : 1;
    try {
      for (int side = 0; side < 2; ++side) {
        const ccdfuzz_patch& body = *query.raw.patches[side];
        std::vector<b2Vec2> points;
        for (std::uint64_t i = 0; i < body.count; ++i) points.push_back(vector(body.positions[i]));
        (side == 0 ? input.proxyA : input.proxyB) = b2MakeProxy(
            points.data(), static_cast<int>(points.size()), adapter::as_float(body.radius));
        b2Sweep& sweep = side == 0 ? input.sweepA : input.sweepB;
        sweep.c2 = vector(body.velocities[0], way);
        sweep.q1 = sweep.q2 = b2Rot_identity;
        if (body.turn_count == 0) continue;
        sweep.localCenter = sweep.c1 = vector(body.turn_centre);
        double end[3];
        for (int k = 0; k < 3; ++k) end[k] = body.turn_centre[k] + body.velocities[0][k];
        sweep.c2 = vector(end);
        sweep.q1 = rotation(body.turn_from);
        sweep.q2 = rotation(body.turn_to);
      }
    } catch (const adapter::Refusal& refusal) {
      return adapter::refused(refusal);
    }
    const b2TOIOutput output = b2TimeOfImpact(&input);
    if (output.state == b2_toiStateFailed) return {};
    return output.state == b2_toiStateSeparated
               ? ccd::Answer::miss()
               : ccd::Answer::hit(adapter::scaled_toi(double{output.fraction}, way));
  }

  adapter::Options options;
  bool turns = false;
};

CCDFUZZ_PLUGIN(Box2d)
