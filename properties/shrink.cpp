#include "properties/shrink.hpp"

namespace ccdfuzz {

std::optional<Counterexample> shrunk_counterexample(const InputRunner& runner,
                                                    const ChoiceNumbers& numbers,
                                                    const ShrinkLimits& limits) {
  const InputRun first = runner(numbers);
  if (!first.fails()) return std::nullopt;
  std::uint64_t spent = 0;
  bool is_over = false;
  // What a sequence draws is what counts, not what is left over of it: a candidate that asks for
  // more choices than it has gets zeros.
  const ChoiceNumbers least = shrunk(numbers, limits.tries, [&](const ChoiceNumbers& candidate) {
    is_over = is_over || (limits.is_over && limits.is_over());
    if (is_over) return false;
    ++spent;
    return runner(candidate).fails_as(first);
  });
  const InputRun last = runner(least);
  if (!last.fails_as(first)) return std::nullopt;
  return Counterexample{least, last.check, spent, is_over};
}

}  // namespace ccdfuzz
