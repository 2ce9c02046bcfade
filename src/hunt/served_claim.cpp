#include "hunt/served_claim.hpp"

#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <stdexcept>
#include <string_view>
#include <system_error>

#include "io/serve.hpp"
#include "method/served_method.hpp"

namespace ccdfuzz {

template <>
struct JsonForm<Check> {
  static void fields(auto& archive, auto& check) {
    archive("status", check.status);
    archive("text", check.text);
  }
};

namespace {

/// Where the choices come from: "numbers", or "draw": a seed and the index of a draw. For "draws",
/// a seed, the first index and how many, the answer is a CheckTally.
struct Question {
  std::string claim, of;
  ChoiceNumbers numbers;
  std::string method, behind;  ///< of a claim about() one: its spec, and that behind its name

  static void fields(auto& archive, auto& question) {
    archive("claim", question.claim);
    archive("of", question.of);
    archive("numbers", question.numbers);
    archive.optional("method", question.method);
    archive.optional("behind", question.behind);
  }
};

Question question_of(const Property& claim, const char* of, const ChoiceNumbers& numbers) {
  return {claim.name, of, numbers, claim.method, spec_behind(claim.method)};
}

/// As the command line of the parent has it.
void admit(const Question& asked) {
  if (is_admitted(asked.method)) return;
  const std::string name = asked.method.substr(asked.method.find(':') + 1);
  const Result<void> admitted =
      asked.behind.empty() ? admit_plugin(asked.method) : name_plugin(name, asked.behind);
  if (!admitted) throw std::invalid_argument(admitted.error().message());
}

/// What draws make are thousands of choices. More are not kept: a child's files end at 16 MiB.
constexpr std::size_t kMostMade = std::size_t{1} << 20;
/// A hang whose choices fit into no argument of a command is repeated by its draw alone. An
/// argument has at most 128 KiB, and a choice at most 20 digits and a comma.
constexpr std::size_t kMostOfAHang = (std::size_t{128} << 10) / 21;

/// The choices of one input as they are made, the last at `place`: later ones were refused.
class MadeWriter {
 public:
  MadeWriter() { static_cast<void>(::ftruncate(ChildProgram::kInherited, 0)); }

  void add(std::size_t place, std::uint64_t choice) {
    if (place >= kMostMade) return;
    const auto at = static_cast<off_t>(place * sizeof choice);
    if (place < size_) static_cast<void>(::ftruncate(ChildProgram::kInherited, at));
    if (::pwrite(ChildProgram::kInherited, &choice, sizeof choice, at) > 0) size_ = place + 1;
  }

 private:
  std::size_t size_ = 0;
};

CheckTally tally_of(std::uint64_t index, const Check& check, const std::string& error) {
  CheckTally tally;
  tally.checked = 1;
  tally.discarded = check.status == Check::Status::kDiscarded ? 1 : 0;
  if (check.status != Check::Status::kFails) return tally;
  tally.failed = 1;
  tally.first_failure = index;
  tally.text = check.text;
  tally.error = error;
  return tally;
}

CheckTally run_on_draws(const Property& property, const ChoiceNumbers& numbers) {
  CheckTally tally;
  for (std::uint64_t i = 0; i < numbers.at(2); ++i) {
    Draw drawn = Draw::mostly_small(Random::keyed({numbers[0], numbers[1] + i}));
    const Check check = run(property, drawn, tally.failed == 0);  // only the first is described
    tally.add(tally_of(numbers[1] + i, check, ""));
  }
  return tally;
}

Check run_and_record(const Property& property, Draw& choices) {
  MadeWriter made;
  choices.watch([&](std::uint64_t choice) { made.add(choices.numbers().size() - 1, choice); });
  return run(property, choices);
}

Check run_on(const Property& property, const Question& question) {
  const ChoiceNumbers& numbers = question.numbers;
  if (question.of == "draw") {
    Draw drawn = Draw::mostly_small(Random::keyed({numbers.at(0), numbers.at(1)}));
    return run_and_record(property, drawn);
  }
  Draw stored = Draw::from_numbers(numbers);
  return run_and_record(property, stored);
}

Descriptor file_in_memory() {
  Descriptor file(::memfd_create("choices", MFD_CLOEXEC));
  if (*file >= 0) return file;
  throw std::system_error(errno, std::generic_category(), "cannot share a file with a process");
}

ChildProgram child_of(const Descriptor& made, const std::atomic<bool>* interrupted,
                      bool starts_plugins) {
  ChildProgram program = value_or_throw(served_child({"--claims"}, kServedLimits));
  program.inherited = *made;
  if (starts_plugins) program.limits.megabytes = 0;  // theirs would be no higher
  program.interrupted = interrupted;
  return program;
}

}  // namespace

std::string served_check(const std::vector<Property>& claims, const std::string& question) {
  const auto asked = value_or_throw(from_json<Question>(question, "the question"));
  const auto claim = std::ranges::find(claims, asked.claim, &Property::name);
  if (claim == claims.end()) throw std::invalid_argument("there is no claim " + asked.claim);
  if (!asked.method.empty()) admit(asked);
  const Property property = value_or_throw(about(*claim, asked.method));
  if (asked.of == "draws") return to_json(run_on_draws(property, asked.numbers));
  return to_json(run_on(property, asked));
}

ServedClaims::ServedClaims(const std::atomic<bool>* interrupted, bool starts_plugins)
    : made_(file_in_memory()), child_(child_of(made_, interrupted, starts_plugins)) {}

void CheckTally::add(const CheckTally& next) {
  if (failed == 0 && next.failed > 0) {
    first_failure = next.first_failure;
    text = next.text;
    error = next.error;
  }
  checked += next.checked;
  discarded += next.discarded;
  failed += next.failed;
  is_cut_short = is_cut_short || next.is_cut_short;
}

InputRun ServedClaims::on_draw(const Property& property, std::uint64_t seed, std::uint64_t index) {
  return ask(property, "draw", {seed, index});
}

CheckTally ServedClaims::on_draws(const Property& property, std::uint64_t seed, std::uint64_t first,
                                  std::uint64_t count) {
  const auto all =
      ask_served<CheckTally>(child_, to_json(question_of(property, "draws", {seed, first, count})));
  if (all) return *all;
  CheckTally tally;
  tally.is_cut_short = all.error().name == "interrupted";
  for (std::uint64_t i = first; i < first + count && !tally.is_cut_short; ++i) {
    const InputRun run = on_draw(property, seed, i);
    tally.is_cut_short = run.error == "interrupted" || run.error == "hang";
    if (run.error != "interrupted") tally.add(tally_of(i, run.check, run.error));
  }
  return tally;
}

InputRun ServedClaims::ask(const Property& property, const char* of, const ChoiceNumbers& numbers) {
  static_cast<void>(::ftruncate(*made_, 0));  // what a child never reads has no choices
  auto said = ask_served<Check>(child_, to_json(question_of(property, of, numbers)));
  InputRun run;
  const off_t size = ::lseek(*made_, 0, SEEK_END);
  ChoiceNumbers made(static_cast<std::size_t>(size) / sizeof made[0]);
  if (::pread(*made_, made.data(), static_cast<std::size_t>(size), 0) == size) run.numbers = made;
  if (!said) {
    run.check = Check::fails(said.error().name + ": " + said.error().note);
    run.error = said.error().name;
    // What it draws until it is stopped may be without end, and zeros after the end of these.
    if (run.error == "hang" && of == std::string_view("numbers")) run.numbers = numbers;
    return run;
  }
  run.check = *std::move(said);
  return run;
}

InputRun ServedClaims::on(const Property& property, const ChoiceNumbers& numbers) {
  return ask(property, "numbers", numbers);
}

std::optional<Counterexample> ServedClaims::least(const Property& property, const InputRun& found,
                                                  const ShrinkLimits& limits) {
  const auto runner = [&](const ChoiceNumbers& numbers) { return on(property, numbers); };
  if (found.error != "hang") return shrunk_counterexample(runner, found.numbers, limits);
  if (found.numbers.size() > kMostOfAHang || !on(property, found.numbers).fails_as(found)) {
    return std::nullopt;
  }
  return Counterexample{found.numbers, found.check, 0, true};
}

}  // namespace ccdfuzz
