#include "properties/shrink.hpp"

namespace ccdfuzz {

InputRunner runner_of(const Property& property) {
  const auto run_on = [property](auto choices) -> InputRun {
    Check check = run(property, choices);
    return {std::move(check), "", choices.numbers(), choices.bytes()};
  };
  return {[=](const ChoiceNumbers& numbers) { return run_on(Draw::from_numbers(numbers)); },
          [=](std::span<const std::uint8_t> bytes) { return run_on(Draw::from_bytes(bytes)); }};
}

std::optional<Counterexample> shrunk_counterexample(const InputRunner& runner,
                                                    const ChoiceNumbers& numbers,
                                                    const ShrinkLimits& limits) {
  const InputRun first = runner.on_numbers(numbers);
  if (!first.fails()) return std::nullopt;
  std::uint64_t spent = 0;
  bool is_over = false;
  // What a sequence draws is what counts, not what is left over of it: a candidate that asks for
  // more choices than it has gets zeros.
  const ChoiceNumbers least = shrunk(numbers, limits.tries, [&](const ChoiceNumbers& candidate) {
    is_over = is_over || (limits.is_over && limits.is_over());
    if (is_over) return false;
    ++spent;
    return runner.on_numbers(candidate).fails_as(first);
  });
  const InputRun last = runner.on_numbers(least);
  if (!last.fails_as(first)) return std::nullopt;
  Counterexample found{least, last.bytes, last.check, spent, is_over};
  // A source at its end gives zeros.
  std::vector<std::uint8_t> shorter = last.bytes;
  while (!shorter.empty() && shorter.back() == 0) shorter.pop_back();
  if (runner.on_bytes(shorter).fails_as(first)) found.bytes = std::move(shorter);
  return found;
}

}  // namespace ccdfuzz
