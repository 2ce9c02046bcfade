#include "ccd/rational/proves_clear.hpp"

#include "base/fp_guard.hpp"
#include "base/verify.hpp"
#include "ccd/rational/tdibm_rational.hpp"

namespace ccdfuzz {

bool proves_clear(const Query& query, const Rational& until, const ClearEffort& most,
                  ClearEffort* spent) {
  const FpGuard guard;
  CCDFUZZ_VERIFY(sgn(until) >= 0);
  Query horizon = query;
  horizon.t_max = round_up(until);  // proves at least what was asked
  SearchOptions options;
  options.precision = 0x1p-30;
  options.max_pops = most.pops;
  options.max_work = most.work;
  thread_local TdibmRational method;
  const Answer answer = method.answer(horizon, options);
  if (spent != nullptr) *spent = {answer.pops, answer.work};
  return answer.verdict == Verdict::kMiss;
}

}  // namespace ccdfuzz
