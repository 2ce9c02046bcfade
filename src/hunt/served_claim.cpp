#include "hunt/served_claim.hpp"

#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <new>
#include <stdexcept>
#include <string_view>
#include <system_error>

#include "base/serve.hpp"
#include "method/served_method.hpp"
#include "properties/choices.hpp"

namespace ccdfuzz {

namespace {

constexpr std::array<std::string_view, 3> kStatuses = {"holds", "fails", "discarded"};

/// Where the choices come from: "numbers" (StoredChoices), "bytes", or the number of "draws".
struct Question {
  std::string of;
  ChoiceNumbers numbers;

  static void fields(auto& archive, auto& question) {
    archive("of", question.of);
    archive("numbers", question.numbers);
  }
};

struct Said {
  std::string status, text;

  static void fields(auto& archive, auto& said) {
    archive("status", said.status);
    archive("text", said.text);
  }
};

struct Made {
  std::uint64_t choice;
  std::uint64_t width;
};
/// More choices are not kept. The largest inputs of fuzz targets have so many bytes, and a choice
/// takes one at least; what draws make has thousands. A child's files end at 16 MiB.
constexpr std::size_t kMostMade = (std::size_t{16} << 20) / sizeof(Made);

/// The choices of one input as they are made.
class MadeWriter {
 public:
  MadeWriter() { static_cast<void>(::ftruncate(ChildProgram::kInherited, 0)); }

  void add(std::uint64_t choice, int width) {
    if (count_ == kMostMade) return;
    const Made made{choice, static_cast<std::uint64_t>(width)};
    const auto at = static_cast<off_t>(count_ * sizeof made);
    if (::pwrite(ChildProgram::kInherited, &made, sizeof made, at) == sizeof made) ++count_;
  }

 private:
  std::size_t count_ = 0;
};

/// As run, but that a want of memory is left to whoever limits it.
Check run_within_memory(const Property& property, ChoiceSource& choices) {
  MadeWriter made;
  choices.watch([&](std::uint64_t choice, int width) { made.add(choice, width); });
  try {
    return property.check(choices);
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& error) {
    return Check::fails(error);
  }
}

Check run_on(const Property& property, const Question& question) {
  const ChoiceNumbers& numbers = question.numbers;
  if (question.of == "draws") {
    RandomChoices drawn = draws_of(numbers.empty() ? 0 : numbers[0]);
    return run_within_memory(property, drawn);
  }
  if (question.of == "numbers") {
    StoredChoices stored(numbers);
    return run_within_memory(property, stored);
  }
  const std::vector<std::uint8_t> bytes(numbers.begin(), numbers.end());
  ByteChoices of_bytes(bytes);
  return run_within_memory(property, of_bytes);
}

ChildProgram child_of(const Property& property, const MadeChoices& made) {
  auto program = served_child({"--claim", std::string(property.name)}, kServedLimits);
  if (!program) throw std::runtime_error(program.error().message());
  program->inherited = made.descriptor();
  return *std::move(program);
}

}  // namespace

std::string served_check(const Property& property, const std::string& question) {
  const auto asked = from_json<Question>(question, "the question");
  if (!asked) throw std::invalid_argument(asked.error().message());
  const Check check = run_on(property, *asked);
  return to_json(
      Said{std::string(kStatuses.at(static_cast<std::size_t>(check.status))), check.text});
}

MadeChoices::MadeChoices() : file_(::memfd_create("choices", MFD_CLOEXEC)) {
  if (file_ < 0) {
    throw std::system_error(errno, std::generic_category(), "cannot share a file with a process");
  }
}

MadeChoices::~MadeChoices() {
  ::close(file_);
}

void MadeChoices::clear() {
  static_cast<void>(::ftruncate(file_, 0));
}

void MadeChoices::read_into(InputRun& run) const {
  Made made{};
  for (off_t at = 0; ::pread(file_, &made, sizeof made, at) == sizeof made; at += sizeof made) {
    run.numbers.push_back(made.choice);
    append_choice(run.bytes, made.choice, static_cast<int>(made.width));
  }
}

ServedClaim::ServedClaim(const Property& property) : child_(child_of(property, made_)) {}

InputRun ServedClaim::ask(const char* of, const ChoiceNumbers& numbers) {
  made_.clear();  // what a child never comes to read has no choices
  const auto said = ask_served<Said>(child_, to_json(Question{of, numbers}));
  InputRun run;
  made_.read_into(run);
  if (!said) {
    run.check = Check::fails(said.error().name + ": " + said.error().note);
    run.error = said.error().name;
    return run;
  }
  const auto* const status = std::ranges::find(kStatuses, said->status);
  run.check = {static_cast<Check::Status>(status - kStatuses.begin()), said->text};
  return run;
}

InputRun ServedClaim::on(const ClaimInput& input) {
  if (input.seed) return ask("draws", {*input.seed});
  return ask("bytes", ChoiceNumbers(input.bytes.begin(), input.bytes.end()));
}

std::optional<Counterexample> ServedClaim::least(const ClaimInput& input, const InputRun& found,
                                                 const ShrinkLimits& limits) {
  const auto of_numbers = [this](const ChoiceNumbers& n) { return ask("numbers", n); };
  const auto of_bytes = [this](std::span<const std::uint8_t> bytes) {
    return ask("bytes", ChoiceNumbers(bytes.begin(), bytes.end()));
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
