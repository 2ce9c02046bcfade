// A plug-in that claims and answers what its options say: "claims=5:kind=2:tolerance=0.5:
// separation=0.25:nan=1", and "verdict=1:toi=0.5:uv=0.25:achieved=0.125", where uv is all four
// parameters. "ordered=1" misses where patch 1 begins ahead of patch 2 in x.
// "within=7:promise=1:points=3:curves=1" narrow what it is asked. "poisoned=2" is its verdict,
// at 0, on what is not finite; without, it is as any other; 8: it hangs; 9: it crashes.
#include <unistd.h>

#include <cmath>
#include <csignal>
#include <cstdlib>
#include <string>

#include "ccdfuzz_plugin.hpp"

namespace ccd = ccdfuzz_plugin_cpp;

struct Claiming {
  std::string options;

  explicit Claiming(const std::string& text) : options(":" + text) {
    if (whole("refuse", 0) == 1) throw std::invalid_argument("as the options say");
  }

  double number(const std::string& key, double otherwise) const {
    const std::size_t at = options.find(":" + key + "=");
    return at == std::string::npos ? otherwise
                                   : std::strtod(options.c_str() + at + key.size() + 2, nullptr);
  }
  std::uint32_t whole(const std::string& key, std::uint32_t otherwise) const {
    return static_cast<std::uint32_t>(number(key, otherwise));
  }

  ccd::Description describe() const {
    ccd::Description d{"claiming", "1"};
    d.claims = whole("claims", d.claims);
    d.tolerance_kind = whole("kind", d.tolerance_kind);
    d.tolerance = number("tolerance", 0);
    d.minimum_separation = number("separation", 0);
    d.nan_policy = whole("nan", d.nan_policy);
    d.within = whole("within", 0);
    if (whole("promise", 0) == 1) d.promise = "all contacts: https://example.org/promise";
    if (whole("curves", 0) == 1) d.pairs = {{{CCDFUZZ_CURVE, CCDFUZZ_CURVE}, {1, 1}}};
    // So many points at most, without a radius.
    if (whole("points", 0) > 0) d.bodies = {{1, whole("points", 0), CCDFUZZ_NO_RADIUS}};
    return d;
  }

  static bool is_finite(const ccd::Query& query) {
    for (int side = 0; side < 2; ++side) {
      const ccd::Patch patch = query.patch(side);
      const ccdfuzz_patch& raw = patch.raw;
      if (!std::isfinite(raw.radius)) return false;
      for (std::size_t i = 0; i < raw.turn_count; ++i) {
        if (!std::isfinite(raw.turn_from[i])) return false;
        if (raw.turn_to != nullptr && !std::isfinite(raw.turn_to[i])) return false;
      }
      for (std::size_t i = 0; i < patch.count(); ++i) {
        for (int k = 0; k < 3; ++k) {
          if (!std::isfinite(patch.at(i, k, 1))) return false;
        }
      }
    }
    return true;
  }

  ccd::Answer answer(const ccd::Query& query) const {
    ccd::Answer answer;
    answer.verdict = whole("verdict", CCDFUZZ_MISS);
    if (answer.verdict == CCDFUZZ_REFUSED) throw ccd::Refusal("as the options say");
    const bool has_ends = query.patch(0).raw.ends != nullptr;
    if (has_ends == (query.patch(0).raw.velocities != nullptr)) throw std::logic_error("not one");
    if (has_ends) answer.verdict = CCDFUZZ_HIT;
    const bool has_weights = query.patch(0).raw.weights != nullptr;
    if (has_weights && query.patch(0).weight(0) != 1) throw std::logic_error("another weight");
    if (has_weights) answer.verdict = CCDFUZZ_HIT;
    const ccdfuzz_patch& first = query.patch(0).raw;
    if (first.loop_count != 0) {
      const bool is_known = first.loop_count == 2 && first.loop_sizes[0] == 3 &&
                            first.loop_sizes[1] == 4 && first.loop_vertices[6][0] == 0.125 &&
                            first.loop_vertices[6][1] == 0.25;
      if (!is_known) throw std::logic_error("other loops");
      answer.verdict = CCDFUZZ_HIT;
    }
    if (first.face_count != 0) {
      const bool is_known = first.face_count == 2 && first.faces[0][2] == 2 &&
                            first.faces[1][2] == 3 && first.count == 4;
      if (!is_known) throw std::logic_error("other faces");
      answer.verdict = first.one_sided == 1 ? CCDFUZZ_HIT : CCDFUZZ_INCONCLUSIVE;
    }
    answer.toi_lower = number("toi", 0);
    if (answer.toi_lower > query.t_max()) answer.toi_lower = query.t_max();
    const bool is_ahead = query.patch(0).at(0, 0, 0) > query.patch(1).at(0, 0, 0);
    if (whole("ordered", 0) == 1 && is_ahead) answer.verdict = CCDFUZZ_MISS;
    answer.tolerance = number("achieved", ccd::kUnknown);
    for (auto& uv : answer.uv) uv[0] = uv[1] = number("uv", ccd::kUnknown);
    const std::uint32_t poisoned = whole("poisoned", 0);
    if (poisoned != 0 && !is_finite(query)) {
      while (poisoned == 8) ::pause();
      if (poisoned == 9) std::raise(SIGSEGV);
      answer.verdict = poisoned;
      answer.toi_lower = 0;
    }
    return answer;
  }
};

CCDFUZZ_PLUGIN(Claiming)
