// What the adapters of Box2D and Box3D share: the time of impact of two shapes. These do not turn,
// but with the option turns=1.
#pragma once

#include "../plugins/adapter.hpp"

namespace adapter {

/// The solver of a plug-in around the types and functions of one of the two.
template <class Engine>
struct Sweeps {
  explicit Sweeps(const std::string& text) {
    Options options(text);
    turns = options.number("turns", 0) != 0;
    options.check_all_known();
  }

  ccd::Description describe() const {
    ccd::Description d = Engine::describe();
    d.version = ENGINE_VERSION;
    // Neither a contact at 0 nor one at the end.
    d.claims = CCDFUZZ_TAKES_BODIES | CCDFUZZ_BINARY32 | CCDFUZZ_ORDINARY | Engine::kClaims;
    d.within = 7;
    // It stops where shapes overlap by its slop, 0.005, at most, to within a quarter of that.
    d.tolerance_kind = CCDFUZZ_TOLERANCE_SPACE;
    d.tolerance = 1.25 * 0.005;
    if (turns) {
      d.claims |= Engine::kTurns;
      d.promise = "none of bodies that turn: its header says that it may miss collisions";
    }
    return d;
  }

  static ccd::Answer answer(const ccd::Query& query) {
    const auto& bodies = query.raw.patches;
    const bool turned = bodies[0]->turn_count > 0 || bodies[1]->turn_count > 0;
    const double step = turned ? 1 : query.t_max();  // what a fraction of 1 is
    typename Engine::Input input{};
    input.maxFraction = turned ? static_cast<float>(query.t_max()) : 1;
    input.sweepA = sweep<decltype(input.sweepA)>(*bodies[0], step);
    input.sweepB = sweep<decltype(input.sweepB)>(*bodies[1], step);
    const auto a = points(*bodies[0]), b = points(*bodies[1]);
    input.proxyA = Engine::proxy(a, as_float(bodies[0]->radius));
    input.proxyB = Engine::proxy(b, as_float(bodies[1]->radius));
    const auto output = Engine::time_of_impact(&input);
    if (output.state == Engine::kFailed) return {};
    if (output.state == Engine::kSeparated) return ccd::Answer::miss();
    return ccd::Answer::hit(scaled_toi(double{output.fraction}, step));
  }

  static auto points(const ccdfuzz_patch& body) {
    std::vector<decltype(Engine::vector(body.positions[0]))> points;
    for (std::uint64_t i = 0; i < body.count; ++i) {
      points.push_back(Engine::vector(body.positions[i]));
    }
    return points;
  }

  template <class Sweep>
  static Sweep sweep(const ccdfuzz_patch& body, double step) {
    Sweep sweep{};
    sweep.q1 = sweep.q2 = Engine::kNoRotation;
    if (body.turn_count > 0) {
      sweep.localCenter = sweep.c1 = Engine::vector(body.turn_centre);
      sweep.q1 = Engine::rotation(body.turn_from);
      sweep.q2 = Engine::rotation(body.turn_to);
    }
    double end[3];
    for (int k = 0; k < 3; ++k) {
      end[k] = (body.turn_count > 0 ? body.turn_centre[k] : 0) + step * body.velocities[0][k];
    }
    sweep.c2 = Engine::vector(end);
    return sweep;
  }

  bool turns = false;
};

}  // namespace adapter
