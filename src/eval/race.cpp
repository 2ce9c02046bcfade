#include "eval/race.hpp"

#include <algorithm>
#include <limits>

#include "base/verify.hpp"
#include "io/cpu_time.hpp"

namespace ccdfuzz {

Race::Race(const std::vector<std::string>& specs, const SearchOptions& options)
    : options_(options) {
  for (const std::string& spec : specs) {
    Result<std::unique_ptr<Method>> method = make_method(spec);
    CCDFUZZ_VERIFY(method.has_value());
    Runner& runner = runners_.emplace_back();
    runner.spec = spec;
    runner.method = std::move(*method);
  }
}

void Race::ask(const Query& query) {
  if (queries_ == 0) {
    for (Runner& runner : runners_) runner.method->answer(query, options_);  // warm
  }
  ++queries_;
  for (Runner& runner : runners_) {
    double least = std::numeric_limits<double>::infinity();
    Answer answer;
    for (int i = 0; i < kRepeats && !(i > 0 && least > kLong); ++i) {
      const double start = thread_cpu_seconds();
      answer = timed_answer(*runner.method, query, options_);
      least = std::min(least, thread_cpu_seconds() - start);
      if (options_.max_seconds < SearchOptions::kNoTimeLimit) {
        const double over = answer.seconds - options_.max_seconds;
        runner.overrun = std::max(runner.overrun.value_or(0), over);
      }
    }
    answer.seconds = least;
    runner.tally.add(answer,
                     answer.verdict == Verdict::kRefused     ? Outcome::kNotAsked
                     : answer.verdict == Verdict::kUndecided ? Outcome::kUndecided
                                                             : Outcome::kUnknown,
                     std::nullopt);
  }
}

}  // namespace ccdfuzz
