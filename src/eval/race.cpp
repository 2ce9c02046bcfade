#include "eval/race.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "io/cpu_time.hpp"

namespace ccdfuzz {

void Race::ask(const Query& query) {
  for (Runner& runner : runners_) {
    try {
      time(runner, query);
    } catch (const MethodFault& fault) {
      ++runner.tally.by_outcome[static_cast<std::size_t>(Outcome::kError)];
      if (runner.fault.empty()) runner.fault = fmt::format("{}: {}", fault.name(), fault.what());
    }
  }
}

void Race::time(Runner& runner, const Query& query) {
  Method& method = methods_[runner.spec];
  const bool is_first = runner.tally.n + runner.tally.not_asked() == 0;
  if (is_first) method.answer(query, options_);  // warm
  double least = std::numeric_limits<double>::infinity();
  Answer answer;
  for (int i = 0; i < kRepeats && !(i > 0 && least > kLong); ++i) {
    const double start = thread_cpu_seconds();
    answer = timed_answer(method, query, options_);
    const double taken = thread_cpu_seconds() - start;
    least = std::min(least, method.runs_elsewhere() ? answer.seconds : taken);
  }
  answer.seconds = least;
  runner.tally.add(answer,
                   answer.verdict == Verdict::kRefused     ? Outcome::kNotAsked
                   : answer.verdict == Verdict::kUndecided ? Outcome::kUndecided
                                                           : Outcome::kUnknown,
                   std::nullopt);
}

}  // namespace ccdfuzz
