#include "hunt/shrink.hpp"

#include <algorithm>

namespace ccdfuzz {

namespace {

constexpr std::uint64_t kTrialsOfAHang = 6;

}  // namespace

Minimised shrink(const Case& found, const std::string& spec, Method& method, const Judged& failure,
                 const SearchOptions& search, MinimiseOptions options) {
  if (failure.error == "hang") options.max_trials = std::min(options.max_trials, kTrialsOfAHang);
  Case start = found;
  start.asked = asked_with(search);
  start.expect.clear();
  Minimised minimised = minimise(
      start, failure.outcome,
      [&](const Case& simpler) {
        const Judged judged = ask(method, simpler, search);
        return judged.outcome == failure.outcome && judged.error == failure.error;
      },
      options);
  minimised.value.expect[spec] = {failure.outcome, failure.error};
  return minimised;
}

}  // namespace ccdfuzz
