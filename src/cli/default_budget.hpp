#pragma once

#include <algorithm>
#include <cstdint>

#include "case/answer.hpp"
#include "case/search_options.hpp"
#include "cli/command.hpp"
#include "files/case_files.hpp"

namespace ccdfuzz {

/// The work of an answer is its pops times this. Measured: for two patches with n control points
/// together, the paper's methods take about 15·n·(n + 100) ns a pair of boxes. That is 0.63 ms for
/// two tensor(8,8) and 0.02 ms for two triangle(2). tdibm-c takes at most an eighth of that, and
/// tdibm-rational as much, plus Answer::work where doubles do not decide.
inline std::uint64_t work_of_a_pop(const Query& query) {
  const std::uint64_t points =
      query.patches[0].positions.size() + query.patches[1].positions.size();
  return points * (points + 100);
}

/// The budget of a run without --max-pops, the same on every machine and number of threads.
class DefaultBudget {
 public:
  /// Limits an answer, so that all default methods together take about 5 s on two close patches
  /// that none can decide. times: a multiple of that budget.
  static void limit(SearchOptions& search, const Query& query, std::uint64_t times) {
    const std::uint64_t pops = times * kWorkOfAnAnswer / work_of_a_pop(query);
    const std::uint64_t most = std::clamp<std::uint64_t>(pops, 1, SearchOptions().max_pops);
    search.max_pops = std::min(search.max_pops, most);
    search.max_work = times * kWorkOfAnAnswer * kExactWork;
  }

  void add(const NamedCase& named, const Answer& answer) {
    work_ += answer.pops * work_of_a_pop(named.value.query) + answer.work / kExactWork;
    ++answers_;
    source_.add(named);
  }
  /// Throws BadInput if nothing is left for this case, the next one of the run.
  void begin(const NamedCase& named) const {
    const std::uint64_t credit =
        std::min(answers_ * kCreditOfAnAnswer, source_.times(kCreditOfAByte));
    if (work_ < kWorkOfARun + credit) return;
    throw BadInput{
        {named.id,
         "this case and all after it are left undecided: the default budget of a run, about 20 "
         "s of counted work and, for each answer, 0.05 s or 1 ms a byte of its file, is spent; "
         "--max-pops N sets one for each answer instead"}};
  }

 private:
  static constexpr std::uint64_t kWorkOfAnAnswer = 40'000'000;  // times 15 ns: 0.6 s
  static constexpr std::uint64_t kExactWork = 12;  // takes as long: measured, 9 to 24 ns
  /// A run may take this and kCreditOfAnAnswer for each answer given: about 20 s, and 0.05 s an
  /// answer. So a file of many of the costliest cases ends, too. Ordinary data sets stay below:
  /// measured, an answer takes 17,000 in the mean for VV RP and 2,200,000 for FF RN of triangle(2).
  /// It takes 6,500,000 for FF RN of tensor(8,8), of which 50 cases are within.
  static constexpr std::uint64_t kDefaultMethodCount = 7;
  static constexpr std::uint64_t kWorkOfARun = 4 * kDefaultMethodCount * kWorkOfAnAnswer;
  static constexpr std::uint64_t kCreditOfAnAnswer = kWorkOfAnAnswer / 12;
  /// A case of FF RN takes some 600 bytes compressed, and seven answers of 2,200,000 each.
  static constexpr std::uint64_t kCreditOfAByte = 1 << 16;

  std::uint64_t work_ = 0, answers_ = 0;
  SourceBytes source_;
};

}  // namespace ccdfuzz
