// The assertions of tdibm-c against faults planted in it. Each of these faults is stopped within a
// few hundred queries, and before any answer is wrong. Nothing stops the right sources. Exits 1 if
// that is not so.

#include <array>
#include <cstdio>
#include <random>
#include <set>
#include <string>
#include <vector>

#include "base/verify.hpp"
#include "ccd/certified/tdibm_c.hpp"
#include "fault_list.hpp"
#include "planted.hpp"

namespace ccdfuzz {
namespace {

constexpr std::array kCaught = {"certified.bound.zero",
                                "certified.bound.extended_precision",
                                "certified.bound.negative",
                                "certified.bound.no_norm",
                                "certified.bound.of_whole",
                                "certified.bound.of_parent",
                                "certified.bound.of_simpler",
                                "certified.bound.half_coordinate",
                                "certified.sub_patch.no_roundings",
                                "certified.sub_patch.one_level",
                                "certified.no_shift",
                                "certified.long_time",
                                "certified.one_underflow",
                                "certified.separated.one_end",
                                "certified.separated.mixed",
                                "certified.separated.touching",
                                "certified.chord.wrong_share",
                                "certified.chord.overshoot",
                                "certified.chord.at_window_end",
                                "certified.chord.other_end",
                                "certified.newton.least",
                                "certified.toi_rounded_up",
                                "certified.magnitude",
                                "certified.toi_of_entry",
                                "certified.toi_end",
                                "certified.drops_short_windows",
                                "certified.parents_window",
                                "certified.stale_snapshot"};

MovingPatch<double> random_patch(std::mt19937_64& random, double scale, double offset) {
  std::uniform_real_distribution<double> any(-1, 1);
  const int degree = 1 + static_cast<int>(random() % 3);
  const Shape shape = random() % 2 == 0 ? Shape::triangle(degree + 1) : Shape::tensor(degree, 2);
  MovingPatch<double> patch{shape, {}, {}};
  const Vec3<double> v(any(random), any(random), any(random));
  for (int i = 0; i < shape.control_count(); ++i) {
    const Vec3<double> p(any(random), any(random), any(random) + offset);
    const Vec3<double> own(any(random), any(random), any(random) - offset);
    patch.positions.push_back(scale * p);
    patch.velocities.push_back(scale * (v + 0.25 * own));
  }
  return patch;
}

/// What stops one of many random queries; empty if nothing does. right: the answers of the right
/// sources, which are made if there are none yet. wrong: how many answers before are misses where
/// these are none.
std::string stop(std::vector<Verdict>& right, int& wrong) {
  constexpr int kQueries = 200;
  std::mt19937_64 random(1);
  TdibmC method;
  wrong = 0;
  for (size_t i = 0; i < kQueries; ++i) {
    const double scale = i % 8 == 7 ? 0x1p1022 : 1;
    const double offset = static_cast<double>(i % 3);
    Query query{{random_patch(random, scale, offset), random_patch(random, scale, 0)}, 1};
    try {
      const Verdict verdict = method.answer(query, {.precision = 0x1p-12, .max_pops = 60}).verdict;
      if (right.size() == i) right.push_back(verdict);
      wrong += verdict == Verdict::kMiss && right[i] != Verdict::kMiss;
    } catch (const InternalError& error) {
      return error.what();
    }
  }
  return "";
}

int run(const std::string& path) {
  const auto faults = read_faults(path);
  if (!faults) return std::fputs("no list of faults\n", stderr), 2;
  int failures = 0, wrong_answers = 0;
  std::vector<Verdict> right;
  const std::set<std::string_view> caught(kCaught.begin(), kCaught.end());
  size_t found = 0;
  if (const std::string why = stop(right, wrong_answers); !why.empty()) {
    std::printf("the right sources stop: %s\n", why.c_str());
    return 1;
  }
  for (size_t i = 0; i < faults->size(); ++i) {
    const PlantedFault& fault = (*faults)[i];
    const bool is_expected = caught.contains(fault.name);
    found += is_expected;
    if (!is_expected) continue;
    planted::active_fault = static_cast<int>(i) + 1;
    const std::string why = stop(right, wrong_answers);
    planted::active_fault = planted::kNone;
    std::printf("%-40s %d wrong before, %s\n", fault.name.c_str(), wrong_answers,
                why.empty() ? "not caught" : why.c_str());
    failures += why.empty() || wrong_answers > 0;
  }
  return failures == 0 && found == caught.size() ? 0 : 1;
}

}  // namespace
}  // namespace ccdfuzz

int main(int argc, char** argv) {
  if (argc == 2) return ccdfuzz::run(argv[1]);
  std::fputs("usage: certified_checked FAULTS\n", stderr);
  return 2;
}
