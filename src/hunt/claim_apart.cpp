#include "hunt/claim_apart.hpp"

#include <cstring>
#include <string_view>

namespace ccdfuzz {

namespace {

// What goes to the copy and comes back are sequences of numbers, each of 8 bytes. A question is
// whether it is of bytes, and their values or the numbers; an answer is the status, how many
// numbers, the numbers, how many bytes, the bytes, and the text.

class Packed {
 public:
  Packed() = default;
  explicit Packed(std::string text) : text_(std::move(text)) {}

  void put(std::uint64_t number) {
    text_.append(reinterpret_cast<const char*>(&number), sizeof number);
  }
  template <class Numbers>
  void put_all(const Numbers& numbers) {
    put(numbers.size());
    for (const auto number : numbers) put(number);
  }
  void put_text(std::string_view text) { text_ += text; }

  std::uint64_t take() {
    std::uint64_t number = 0;
    std::memcpy(&number, text_.data() + taken_, sizeof number);
    taken_ += sizeof number;
    return number;
  }
  template <class Numbers>
  Numbers take_all() {
    Numbers numbers(take());
    for (auto& number : numbers) number = static_cast<typename Numbers::value_type>(take());
    return numbers;
  }
  std::string take_text() const { return text_.substr(taken_); }

  const std::string& text() const { return text_; }

 private:
  std::string text_;
  std::size_t taken_ = 0;
};

template <class Numbers>
std::string question_of(bool is_bytes, const Numbers& numbers) {
  Packed question;
  question.put(is_bytes ? 1 : 0);
  question.put_all(numbers);
  return question.text();
}

std::string run_packed(const Property& property, const std::string& question) {
  Packed asked(question);
  const bool is_bytes = asked.take() != 0;
  const auto numbers = asked.take_all<ChoiceNumbers>();
  const std::vector<std::uint8_t> bytes(numbers.begin(), numbers.end());
  ByteChoices of_bytes(bytes);
  StoredChoices of_numbers(numbers);
  ChoiceSource& choices = is_bytes ? static_cast<ChoiceSource&>(of_bytes) : of_numbers;
  const Check check = run(property, choices);
  Packed answer;
  answer.put(static_cast<std::uint64_t>(check.status));
  answer.put_all(choices.numbers());
  answer.put_all(choices.bytes());
  answer.put_text(check.text);
  return answer.text();
}

}  // namespace

ClaimApart::ClaimApart(const Property& property, const ApartLimits& limits)
    : apart_([property](const std::string& question) { return run_packed(property, question); },
             limits) {}

InputRun ClaimApart::ask(const std::string& question) {
  const auto text = apart_.ask(question);
  if (!text) {
    const MethodFault& fault = text.error();
    return {Check::fails(fault.name() + ": " + fault.what()), fault.name(), {}, {}};
  }
  Packed answer(*text);
  InputRun run;
  run.check.status = static_cast<Check::Status>(answer.take());
  run.numbers = answer.take_all<ChoiceNumbers>();
  run.bytes = answer.take_all<std::vector<std::uint8_t>>();
  run.check.text = answer.take_text();
  return run;
}

InputRun ClaimApart::on_bytes(std::span<const std::uint8_t> bytes) {
  return ask(question_of(true, bytes));
}

InputRun ClaimApart::on_numbers(const ChoiceNumbers& numbers) {
  return ask(question_of(false, numbers));
}

std::optional<Counterexample> ClaimApart::least(std::span<const std::uint8_t> bytes,
                                                const InputRun& found, const ShrinkLimits& limits) {
  const auto on_bytes_alone = [this](std::span<const std::uint8_t> candidate) {
    InputRun run = on_bytes(candidate);
    run.bytes.assign(candidate.begin(), candidate.end());
    return run;
  };
  const ChoiceNumbers as_numbers(bytes.begin(), bytes.end());
  if (found.error == "hang") {
    return Counterexample{as_numbers, {bytes.begin(), bytes.end()}, found.check, 0, true};
  }
  if (!found.error.empty()) {
    const auto on_values = [&](const ChoiceNumbers& values) {
      return on_bytes_alone(std::vector<std::uint8_t>(values.begin(), values.end()));
    };
    return shrunk_counterexample({on_values, on_bytes_alone}, as_numbers, limits);
  }
  return shrunk_counterexample({[this](const ChoiceNumbers& n) { return on_numbers(n); },
                                [this](std::span<const std::uint8_t> b) { return on_bytes(b); }},
                               found.numbers, limits);
}

}  // namespace ccdfuzz
