#pragma once

#include <string>
#include <vector>

#include "eval/tally.hpp"
#include "method/method_set.hpp"

namespace ccdfuzz {

/// Times methods on the same queries, by turns in one thread. Their ratios then depend little on
/// the machine and its load. Times are the least of up to kRepeats answers, of one where that took
/// longer than kLong. They are CPU time, but of a plug-in what an answer says (timed_answer).
class Race {
 public:
  static constexpr int kRepeats = 3;
  static constexpr double kLong = 0.01;

  struct Runner {
    std::string spec;
    /// By outcomes undecided (the time is a lower bound), not asked, error and unknown.
    Tally tally = {};
    std::string fault = {};  ///< the first, in words; mostly none
  };

  /// Requires specs that parse_method accepts.
  Race(const std::vector<std::string>& specs, const SearchOptions& options) : options_(options) {
    for (const std::string& spec : specs) runners_.push_back({spec});
  }

  /// Asks all of them one query.
  void ask(const Query& query);

  const std::vector<Runner>& runners() const { return runners_; }

 private:
  void time(Runner& runner, const Query& query);

  SearchOptions options_;
  MethodSet methods_;
  std::vector<Runner> runners_;
};

}  // namespace ccdfuzz
