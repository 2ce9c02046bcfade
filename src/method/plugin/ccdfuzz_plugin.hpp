// A ccdfuzz plug-in in C++17: a class with an answer, and one macro. Nothing to link.
//
//   struct Mine {
//     explicit Mine(const std::string& options) {}
//     ccdfuzz_plugin_cpp::Description describe() const { return {"mine", "1.0"}; }
//     ccdfuzz_plugin_cpp::Answer answer(const ccdfuzz_plugin_cpp::Query& query);
//   };
//   CCDFUZZ_PLUGIN(Mine)
//
// A Refusal that an answer throws says that it does not take the query. Anything else that an
// answer throws becomes an error with the exception's text. A constructor or describe() that throws
// refuses the options, with that text.
#pragma once

#include <algorithm>
#include <cstring>
#include <exception>
#include <limits>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include <ccdfuzz_plugin.h>

namespace ccdfuzz_plugin_cpp {

inline constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

struct Patch {
  const ccdfuzz_patch& raw;

  std::size_t count() const { return static_cast<std::size_t>(raw.count); }
  /// Coordinate k of control point i at time t, rounded, but for the ends at 1. It ignores a turn
  /// or a spin of a body.
  double at(std::size_t i, int k, double t) const {
    const double p = raw.positions[i][k];
    if (raw.ends != nullptr) return t == 1 ? raw.ends[i][k] : p + t * (raw.ends[i][k] - p);
    return p + t * raw.velocities[raw.shape == CCDFUZZ_HULL ? 0 : i][k];
  }
  double weight(std::size_t i) const { return raw.weights != nullptr ? raw.weights[i] : 1; }
};

struct Query {
  const ccdfuzz_query& raw;

  Patch patch(int side) const { return {*raw.patches[side]}; }
  double t_max() const { return raw.t_max; }
};

/// Thrown by an answer to a query that it does not promise to answer (CCDFUZZ_REFUSED).
struct Refusal : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// How each field is meant: ccdfuzz_answer.
struct Answer {
  std::uint32_t verdict = CCDFUZZ_INCONCLUSIVE;
  double toi_lower = kUnknown;
  double toi_upper = kUnknown;
  double uv[2][2] = {{kUnknown, kUnknown}, {kUnknown, kUnknown}};
  std::uint64_t iterations = 0;
  double tolerance = kUnknown;
  std::string message{};

  static Answer hit(double toi) {
    Answer answer;
    answer.verdict = CCDFUZZ_HIT;
    answer.toi_lower = toi;
    return answer;
  }
  static Answer miss() {
    Answer answer;
    answer.verdict = CCDFUZZ_MISS;
    return answer;
  }
};

/// How each field is meant: ccdfuzz_description. `claims` starts with a closed [0, t_max].
struct Description {
  std::string name;
  std::string version;
  std::uint32_t claims = CCDFUZZ_CLOSED_T_MAX | CCDFUZZ_CONTACT_AT_ZERO;
  std::vector<ccdfuzz_pair> pairs{};
  std::uint32_t tolerance_kind = CCDFUZZ_TOLERANCE_TIME;
  double tolerance = 0;
  double minimum_separation = 0;
  std::uint32_t nan_policy = CCDFUZZ_NAN_UNDEFINED;
  std::string promise{};
  std::uint64_t within = 0;
  std::vector<ccdfuzz_body_kind> bodies{};
};

/// Point and triangle, and two segments: the pairs of a linear mesh.
inline std::vector<ccdfuzz_pair> linear_pairs() {
  return {{{CCDFUZZ_POINT, CCDFUZZ_TRIANGLE}, {0, 1}}, {{CCDFUZZ_CURVE, CCDFUZZ_CURVE}, {1, 1}}};
}

/// Two bodies, of as many points as there may be.
inline std::vector<ccdfuzz_pair> body_pairs() {
  return {{{CCDFUZZ_HULL, CCDFUZZ_HULL}, {81, 81}}};
}

/// The C functions around a Solver.
template <class Solver>
struct Wrapped {
  Description description;
  Solver solver;

  explicit Wrapped(const std::string& options) : solver(options) {
    description = solver.describe();
  }

  static std::int32_t create(const char* options, void** state) {
    *state = new Wrapped(options);
    return 0;
  }
  static void destroy(void* state) { delete static_cast<Wrapped*>(state); }

  static std::int32_t describe(void* state, ccdfuzz_description* out) {
    const Description& d = static_cast<Wrapped*>(state)->description;
    out->size = std::min<std::uint32_t>(out->size, sizeof *out);
    out->claims = d.claims;
    out->name = d.name.c_str();
    out->version = d.version.c_str();
    out->pairs = d.pairs.data();
    out->pair_count = d.pairs.size();
    out->tolerance_kind = d.tolerance_kind;
    out->nan_policy = d.nan_policy;
    out->tolerance = d.tolerance;
    out->minimum_separation = d.minimum_separation;
    out->promise = d.promise.c_str();
    out->within = d.within;
    out->bodies = d.bodies.data();
    out->body_count = d.bodies.size();
    return 0;
  }

  static std::int32_t answer(void* state, const ccdfuzz_query* query, ccdfuzz_answer* out) {
    Answer answer;
    try {
      answer = static_cast<Wrapped*>(state)->solver.answer(Query{*query});
    } catch (const std::exception& thrown) {
      const bool is_refusal = dynamic_cast<const Refusal*>(&thrown) != nullptr;
      answer.verdict = is_refusal ? CCDFUZZ_REFUSED : CCDFUZZ_ERROR;
      answer.message = thrown.what();
    } catch (...) {
      return 1;
    }
    out->size = std::min<std::uint32_t>(out->size, sizeof *out);
    out->verdict = answer.verdict;
    out->toi_lower = answer.toi_lower;
    out->toi_upper = answer.toi_upper;
    std::memcpy(out->uv, answer.uv, sizeof answer.uv);
    out->iterations = answer.iterations;
    out->tolerance = answer.tolerance;
    answer.message.resize(std::min(answer.message.size(), sizeof out->message - 1));
    std::memcpy(out->message, answer.message.c_str(), answer.message.size() + 1);
    return 0;
  }
};

}  // namespace ccdfuzz_plugin_cpp

/// Exports the class Solver of this library as its plug-in.
#define CCDFUZZ_PLUGIN(Solver)                                                                \
  extern "C" __attribute__((visibility("default"))) const ccdfuzz_plugin* ccdfuzz_plugin_get( \
      void) {                                                                                 \
    using Wrapped = ccdfuzz_plugin_cpp::Wrapped<Solver>;                                      \
    static const ccdfuzz_plugin plugin = {sizeof(ccdfuzz_plugin), CCDFUZZ_PLUGIN_ABI,         \
                                          Wrapped::create,        Wrapped::destroy,           \
                                          Wrapped::describe,      Wrapped::answer};           \
    return &plugin;                                                                           \
  }
