// Ten faults, each found by RapidCheck from nothing and its case of the inverse construction
// shrunk. Measures how long that takes, and what is left of the significant bits of the numbers.
// Prints a table.
#include <fmt/format.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cstdlib>
#include <functional>

#include "base/stopwatch.hpp"
#include "bench/median.hpp"
#include "finds/content_address.hpp"
#include "generators/rc/rapidcheck.hpp"

namespace ccdfuzz {
namespace {

Answer right_answer(const Query& query) {
  thread_local const std::unique_ptr<Method> method = *make_method("tdibm-c");
  return method->answer(query, {});
}

/// A certified method that is asked of the query after `spoil`: what a fault would make of it.
template <class Spoil>
auto asked_after(const Spoil& spoil) {
  return [spoil](Query query) {
    spoil(query);
    return right_answer(query);
  };
}

void round_to_float(Points<double>& points) {
  for (Vec3<double>& p : points) p = p.cast<float>().cast<double>();
}

struct PlantedFault {
  const char* says;
  std::function<Answer(const Query&)> answer;
};

std::vector<PlantedFault> planted_faults() {
  return {
      {"the last control point of patch 1 is left out", asked_after([](Query& query) {
         MovingPatch<double>& patch = query.patches[0];
         if (patch.positions.size() < 2) return;
         patch.positions.back() = patch.positions.front();
         patch.velocities.back() = patch.velocities.front();
       })},
      {"patch 2 moves backwards", asked_after([](Query& query) {
         for (Vec3<double>& v : query.patches[1].velocities) v = -v;
       })},
      {"the end of the time step does not count",
       asked_after([](Query& query) { query.t_max *= 1 - 0x1p-20; })},
      {"positions are floats", asked_after([](Query& query) {
         for (MovingPatch<double>& patch : query.patches) round_to_float(patch.positions);
       })},
      {"velocities are floats", asked_after([](Query& query) {
         for (MovingPatch<double>& patch : query.patches) round_to_float(patch.velocities);
       })},
      {"patches move as a whole", asked_after([](Query& query) {
         for (MovingPatch<double>& patch : query.patches) {
           for (Vec3<double>& v : patch.velocities) v = patch.velocities.front();
         }
       })},
      {"x and y of a velocity are swapped", asked_after([](Query& query) {
         for (Vec3<double>& v : query.patches[0].velocities) std::swap(v[0], v[1]);
       })},
      {"patches at rest are asleep", asked_after([](Query& query) {
         for (MovingPatch<double>& patch : query.patches) {
           const bool rests = std::ranges::all_of(
               patch.velocities, [](const Vec3<double>& v) { return v.squaredNorm() < 1; });
           if (rests) patch.velocities.assign(patch.velocities.size(), Vec3<double>(0, 0, 0));
         }
       })},
      {"hits are late by a thousandth",
       [](const Query& query) {
         Answer answer = right_answer(query);
         if (answer.verdict == Verdict::kHit) *answer.toi += query.t_max / 1000;
         return answer;
       }},
      {"only the boxes at the end of the step count",
       [](const Query& query) {
         std::array<Eigen::AlignedBox3d, 2> boxes;
         for (size_t s = 0; s < 2; ++s) {
           for (const auto& p : query.patches[s].at(query.t_max)) boxes[s].extend(p);
         }
         return boxes[0].intersects(boxes[1]) ? Answer::hit(0) : Answer::miss();
       }},
  };
}

struct Found {
  double seconds = 0;
  std::uint64_t drawn_bits = 0, shrunk_bits = 0;
};

/// Runs the property once, with this seed. nullopt if 100 cases do not find the fault.
std::optional<Found> find(const PlantedFault& fault, std::uint64_t seed) {
  Found found;
  rc::detail::TestParams parameters;
  parameters.seed = seed;
  const Stopwatch watch;
  const rc::detail::TestResult result = rc::detail::checkTestable(
      [&] {
        const Case value = *gen::inverse();
        const std::optional<Contact> contact = contact_of(value);
        RC_PRE(contact.has_value());
        if (!is_false_negative(*contact, fault.answer(value.query))) return;
        const std::uint64_t bits = size_of(value.query).significant_bits;
        if (found.drawn_bits == 0) found.drawn_bits = bits;
        found.shrunk_bits = bits;  // the last that fails is what is shown
        RC_FAIL("missed");
      },
      rc::detail::TestMetadata{}, parameters);
  found.seconds = watch.seconds();
  rc::detail::FailureResult failure;
  return result.match(failure) ? std::optional(found) : std::nullopt;
}

int run(std::uint64_t seeds) {
  std::vector<double> shares;
  fmt::print(
      "| fault | found with | seconds | longest | bits drawn | bits shrunk |\n"
      "|:--|--:|--:|--:|--:|--:|\n");
  for (const PlantedFault& fault : planted_faults()) {
    std::vector<double> seconds, shares_here;
    std::vector<std::uint64_t> drawn, shrunk;
    for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
      const std::optional<Found> found = find(fault, seed);
      if (!found) continue;
      seconds.push_back(found->seconds);
      drawn.push_back(found->drawn_bits);
      shrunk.push_back(found->shrunk_bits);
      shares_here.push_back(static_cast<double>(found->shrunk_bits) /
                            static_cast<double>(found->drawn_bits));
    }
    if (seconds.empty()) {
      fmt::print("| {} | 0 of {} seeds | | | | |\n", fault.says, seeds);
      continue;
    }
    shares.push_back(median(shares_here));
    fmt::print("| {} | {} of {} seeds | {:.2f} | {:.2f} | {} | {} |\n", fault.says, seconds.size(),
               seeds, median(seconds), *std::ranges::max_element(seconds), median(drawn),
               median(shrunk));
  }
  fmt::print("\nof the bits drawn, shrinking leaves {:.1f} % in the median\n",
             100 * median(shares));
  return shares.size() == planted_faults().size() ? 0 : 1;
}

}  // namespace
}  // namespace ccdfuzz

int main(int argc, char** argv) {
  return ccdfuzz::run(argc > 1 ? std::strtoull(argv[1], nullptr, 10) : 5);
}
