#include "hunt/claim_apart.hpp"

#include <cstring>
#include <new>
#include <string_view>

namespace ccdfuzz {

namespace {

/// What goes to the copy and comes back: numbers of 8 bytes, and sequences of them. A question is
/// what the numbers are, and the numbers; an answer is the status and the text.
class Packed {
 public:
  Packed() = default;
  explicit Packed(std::string text) : text_(std::move(text)) {}

  void put(std::uint64_t number) {
    text_.append(reinterpret_cast<const char*>(&number), sizeof number);
  }
  void put_all(const ChoiceNumbers& numbers) {
    put(numbers.size());
    for (const std::uint64_t number : numbers) put(number);
  }
  void put_text(std::string_view text) { text_ += text; }

  std::uint64_t take() {
    std::uint64_t number = 0;
    std::memcpy(&number, text_.data() + taken_, sizeof number);
    taken_ += sizeof number;
    return number;
  }
  ChoiceNumbers take_all() {
    ChoiceNumbers numbers(take());
    for (std::uint64_t& number : numbers) number = take();
    return numbers;
  }
  std::string take_text() const { return text_.substr(taken_); }

  const std::string& text() const { return text_; }

 private:
  std::string text_;
  std::size_t taken_ = 0;
};

/// As run, but that a want of memory is left to whoever limits it.
Check run_within_memory(const Property& property, ChoiceSource& choices) {
  try {
    return property.check(choices);
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& error) {
    return Check::fails(error);
  }
}

}  // namespace

std::string ClaimApart::run_packed(const Property& property, SharedChoices& made,
                                   const std::string& question) {
  made.clear();
  Packed asked(question);
  const auto of = static_cast<Of>(asked.take());
  const auto numbers = asked.take_all();
  const std::vector<std::uint8_t> bytes(numbers.begin(), numbers.end());
  StoredChoices of_numbers(numbers);
  ByteChoices of_bytes(bytes);
  RandomChoices drawn = draws_of(numbers.empty() ? 0 : numbers[0]);
  ChoiceSource* const choices = of == Of::kNumbers ? static_cast<ChoiceSource*>(&of_numbers)
                                : of == Of::kBytes ? static_cast<ChoiceSource*>(&of_bytes)
                                                   : &drawn;
  choices->watch([&](std::uint64_t choice, int width) { made.add(choice, width); });
  const Check check = run_within_memory(property, *choices);
  Packed answer;
  answer.put(static_cast<std::uint64_t>(check.status));
  answer.put_text(check.text);
  return answer.text();
}

ClaimApart::ClaimApart(const Property& property, const ApartLimits& limits)
    : apart_([this, property](
                 const std::string& question) { return run_packed(property, made_, question); },
             limits) {}

InputRun ClaimApart::ask(Of of, const ChoiceNumbers& numbers) {
  Packed question;
  question.put(static_cast<std::uint64_t>(of));
  question.put_all(numbers);
  made_.clear();  // what a copy never comes to read has no choices
  const auto text = apart_.ask(question.text());
  InputRun run;
  run.numbers = made_.numbers();
  run.bytes = made_.bytes();
  if (!text) {
    const MethodFault& fault = text.error();
    run.check = Check::fails(fault.name() + ": " + fault.what());
    run.error = fault.name();
    return run;
  }
  Packed answer(*text);
  run.check.status = static_cast<Check::Status>(answer.take());
  run.check.text = answer.take_text();
  return run;
}

InputRun ClaimApart::on(const ClaimInput& input) {
  if (input.seed) return ask(Of::kDraws, {*input.seed});
  return ask(Of::kBytes, ChoiceNumbers(input.bytes.begin(), input.bytes.end()));
}

std::optional<Counterexample> ClaimApart::least(const ClaimInput& input, const InputRun& found,
                                                const ShrinkLimits& limits) {
  const auto of_numbers = [this](const ChoiceNumbers& n) { return ask(Of::kNumbers, n); };
  const auto of_bytes = [this](std::span<const std::uint8_t> bytes) {
    return ask(Of::kBytes, ChoiceNumbers(bytes.begin(), bytes.end()));
  };
  if (found.error != "hang") {
    return shrunk_counterexample({of_numbers, of_bytes}, found.numbers, limits);
  }
  // What it draws until it is stopped may be without end, and zeros after the end of its bytes.
  if (!input.seed) {
    return Counterexample{
        found.numbers, {input.bytes.begin(), input.bytes.end()}, found.check, 0, true};
  }
  if (!of_bytes(found.bytes).fails_as(found)) return std::nullopt;
  return Counterexample{found.numbers, found.bytes, found.check, 0, true};
}

}  // namespace ccdfuzz
