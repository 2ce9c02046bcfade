#include "ccd/witness_trace/certified_tracer.hpp"

#include "base/fp_guard.hpp"
#include "base/verify.hpp"
#include "ccd/certified/linear_advance.hpp"

namespace ccdfuzz {

const Trace& CertifiedTracer::trace(const Query& query, const Witness& witness,
                                    const TraceOptions& options) {
  const FpGuard guard;
  CCDFUZZ_VERIFY(is_taken(query, {.precision = options.precision}) && sgn(witness.t) >= 0);
  const int target = depth_for(options.precision);
  split_.take(query);
  const int exponent = split_.query().time;
  path_.assign(split_.query().shapes, witness, exponent);
  CCDFUZZ_VERIFY(path_.time().hi <= split_.query().t_max);
  watch_.begin(path_.time(), options.steps, exponent);
  now_.clear();
  for (auto* level : {&now_, &next_}) level->reserve(kMostOfLevel);
  const auto& shapes = split_.query().shapes;
  if (is_linear_pair(shapes[0], shapes[1]) && !is_trimmed(query)) {
    follow_linear(query, options);
  } else {
    split_.begin(target);
    now_.push_back({{0, split_.query().t_max}, {}, {}, {}});
  }
  for (int level = 0; level < target && !now_.empty(); ++level) {
    next_.clear();
    for (const certified::CellPair& pair : now_) split(pair, options);
    std::swap(now_, next_);
  }
  return watch_.trace();
}

void CertifiedTracer::follow_linear(const Query& query, const TraceOptions& options) {
  const Window whole{0, split_.query().t_max};
  watch_.look_at({0, {}, whole});
  certified::advance(split_.query(), &watch_);
  const Answer answer = linear_.answer(query, {.precision = options.precision});
  std::optional<Window> left;
  if (answer.verdict != Verdict::kMiss) {
    const double toi = certified::original_time(answer.toi.value_or(0), -split_.query().time);
    left = {toi, whole.hi};
  }
  watch_.judge(left);
}

void CertifiedTracer::split(const certified::CellPair& pair, const TraceOptions& options) {
  PairParts parts;
  const std::array<Cell, 2> cells = {split_.tree(0).cell(pair.cells[0]),
                                     split_.tree(1).cell(pair.cells[1])};
  parts.split(split_.query().shapes, cells);
  for_each_choice(path_, parts, options.all, [&](int a, int b) {
    const std::array<Cell, 2> tested = {parts.cells[0][static_cast<size_t>(a)],
                                        parts.cells[1][static_cast<size_t>(b)]};
    watch_.look_at({pair.depths[0] + 1, tested, pair.window});
    std::array<certified::CellPair, certified::PairSplit::kMostPairs> kept;
    std::optional<Window> left;
    if (split_.split(pair, {1U << a, 1U << b}, kept, &watch_) > 0) {
      left = kept[0].window;
      // A pair whose window lost the witness is not followed further.
      if (watch_.holds(*left)) next_.push_back(kept[0]);
    }
    watch_.judge(left);
  });
}

}  // namespace ccdfuzz
