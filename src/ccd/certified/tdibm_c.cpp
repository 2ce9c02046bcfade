#include "ccd/certified/tdibm_c.hpp"

#include <cmath>

#include "base/fp_guard.hpp"
#include "base/verify.hpp"
#include "ccd/certified/linear_advance.hpp"
#include "ccd/certified/linear_contact.hpp"
#include "ccd/certified/rough_contact.hpp"
#include "ccd/past_start.hpp"

namespace ccdfuzz {

namespace {

/// The queue orders by the window's start in buckets of t_max·2^-20, deeper first within a bucket:
/// near-ties go deep rather than wide. toi does not suffer: it is the least start of all that is
/// left.
constexpr double kTimeBuckets = 0x1p20;

/// Contacts of linear patches are within 2^-44 of the time step, since it costs no more than 2^-14.
constexpr int kLevelOfLinearTimes = 44;

/// What a hit on linear patches says that are not decided exactly.
constexpr const char* kNotProven = "contact not proven";

}  // namespace

bool TdibmC::Entry::later(const Entry& x, const Entry& y) {
  if (x.time_bucket != y.time_bucket) return x.time_bucket > y.time_bucket;
  if (x.depth != y.depth) return x.depth < y.depth;
  return x.order > y.order;
}

Answer TdibmC::answer(const Query& query, const SearchOptions& options) {
  if (!is_taken(query, options)) return refusal(query, options);
  const FpGuard guard;
  Answer answer = decide(query, options);
  queue_.clear();
  split_.clear();
  queue_.keep_at_most(kKeptBytes / 2);
  split_.keep_at_most(kKeptBytes / 2);
  return past_start(query, std::move(answer));
}

double TdibmC::earliest(double so_far) const {
  for (size_t i = 0; i < queue_.size(); ++i) so_far = std::min(so_far, queue_[i].window.lo);
  const double toi = certified::original_time(so_far, split_.query().time);
  CCDFUZZ_ASSERT(std::ldexp(toi, -split_.query().time) <= so_far);
  return toi;
}

void TdibmC::push(const certified::CellPair& pair) {
  CCDFUZZ_ASSERT(pair.window.lo <= pair.window.hi);
  const double t_max = split_.query().t_max;
  const double bucket = t_max > 0 ? pair.window.lo / t_max * kTimeBuckets : 0;
  const auto depth = static_cast<std::uint16_t>(pair.depths[0] + pair.depths[1]);
  queue_.push({pair, depth, static_cast<std::uint32_t>(bucket), pushed_++});
}

std::optional<Answer> TdibmC::decide_linear(const Query& query, const SearchOptions& options,
                                            int target, double& from) {
  const certified::NormalisedQuery& normalised = split_.query();
  certified::Tiers& tiers = split_.tiers();
  Answer answer;
  answer.verdict = Verdict::kMiss;
  const certified::Advancement advanced = certified::advance(normalised);
  if (advanced.kind == certified::Advancement::Kind::kClear) {
    ++tiers.advancement;
    return answer;
  }
  const auto hit = [&](double time, double toi) {
    answer.verdict = Verdict::kHit;
    answer.toi = std::max(toi, certified::original_time(time, normalised.time));
    answer.uv = certified::nearest_parameters(normalised,
                                              std::max(time, std::ldexp(toi, -normalised.time)));
    return answer;
  };
  const bool stopped = advanced.kind == certified::Advancement::Kind::kStopped;
  if (query.separation > 0) {
    // No polynomial is known whose sign decides: what doubles do not tell from d is a hit.
    if (stopped) return hit(advanced.time, 0);
    from = advanced.time;
    return std::nullopt;
  }
  // Half the precision is the window's, the rest is more than all roundings.
  const double width = 0.5 * options.precision * normalised.t_max;
  const double before = std::max(0.0, advanced.time - 0.5 * width);
  const certified::RoughContact rough =
      certified::rough_contact(normalised, before, stopped ? before + width : 0, width);
  tiers.doubles += rough.kind != certified::RoughContact::Kind::kOpen;
  if (rough.kind == certified::RoughContact::Kind::kNone) return answer;
  if (rough.kind == certified::RoughContact::Kind::kProven) {
    return hit(std::max(rough.time, advanced.time), 0);
  }

  using Kind = certified::LinearContact::Kind;
  const certified::LinearContact contact =
      certified::first_linear_contact(query, std::max(target, kLevelOfLinearTimes));
  ++tiers.integers;
  if (contact.kind == Kind::kNone) return answer;
  if (contact.kind != Kind::kProven) answer.note = kNotProven;
  if (contact.kind != Kind::kTooWide || stopped) return hit(advanced.time, contact.toi);
  from = advanced.time;
  return std::nullopt;
}

Answer TdibmC::decide(const Query& query, const SearchOptions& options) {
  // Halves at least, however wide a hit may be: the whole patches are not tested.
  const int target = std::max(depth_for(options.precision), 1);
  Deadline deadline(options);
  split_.take(query);
  const certified::NormalisedQuery& normalised = split_.query();
  queue_.clear();
  pushed_ = 0;
  Answer answer;
  double from = 0;
  const bool is_linear = is_linear_pair(normalised.shapes[0], normalised.shapes[1]);
  if (is_linear && !is_trimmed(query)) {
    if (const std::optional<Answer> decided = decide_linear(query, options, target, from)) {
      return *decided;
    }
    if (query.separation == 0) answer.note = kNotProven;
  }
  split_.begin(target);
  push({{from, normalised.t_max}, {}, {}, {}});
  std::array<certified::CellPair, certified::PairSplit::kMostPairs> kept;
  // A pop takes it at most 16 tests, of up to 1 ms all together.
  const int work_of_pop = split_.tree(0).count() + split_.tree(1).count();

  while (!queue_.empty()) {
    const bool out_of_pops = answer.pops == options.max_pops;
    const bool out_of_time = deadline.passed(work_of_pop);
    const std::uint64_t used = bytes();
    answer.bytes = std::max(answer.bytes, used);
    // What earlier queries left in other buffers than those that grow now.
    if (queue_.held() + split_.held() > used + SearchOptions::kGrowthBytes / 2 &&
        queue_.held() + split_.held() > options.max_bytes) {
      queue_.keep_at_most(0);
      split_.keep_at_most(0);
    }
    if (out_of_pops || out_of_time || used > options.max_bytes) {
      answer.verdict = Verdict::kUndecided;
      answer.toi = earliest(normalised.t_max);
      answer.note = out_of_pops   ? "pop budget exhausted"
                    : out_of_time ? "time budget exhausted"
                                  : "memory budget exhausted";
      return answer;
    }
    const Entry entry = queue_.pop();
    ++answer.pops;
    if (entry.least_depth() >= target) {
      answer.verdict = Verdict::kHit;
      answer.toi = earliest(entry.window.lo);
      CCDFUZZ_ASSERT(std::ldexp(*answer.toi, -normalised.time) <= entry.window.lo);
      CCDFUZZ_ASSERT(queue_.empty() ||
                     *answer.toi <= std::ldexp(queue_[0].window.lo, normalised.time));
      for (int s = 0; s < 2; ++s) {
        answer.uv[s] = split_.tree(s).cell(entry.cells[s]).centre(normalised.shapes[s]);
      }
      return answer;
    }
    const int count = split_.split(entry, certified::PairSplit::kAll, kept);
    for (int i = 0; i < count; ++i) push(kept[static_cast<size_t>(i)]);
  }
  answer.verdict = Verdict::kMiss;
  answer.note.clear();
  return answer;
}

}  // namespace ccdfuzz
