// `ccdfuzz check` where properties do not hold, or worse: the program misbehaving_properties.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "process.hpp"

namespace ccdfuzz {
namespace {

using testing::HasSubstr;
using testing::Not;

constexpr const char* kProgram = CCDFUZZ_TEST_MISBEHAVING_PROPERTIES;

Finished misbehaving(const std::vector<std::string>& arguments) {
  return Process(with({"check"}, arguments), "", kProgram).wait();
}

/// The rest of the line that begins so; empty if there is none.
std::string line_after(const std::string& text, const std::string& beginning) {
  const size_t at = text.find("\n" + beginning);
  if (at == std::string::npos) return "";
  const size_t from = at + 1 + beginning.size();
  return text.substr(from, text.find('\n', from) - from);
}

struct Crash {
  std::string property, error;
  int signal;
};

class CrashingProperty : public testing::TestWithParam<Crash> {};

TEST_P(CrashingProperty, IsAFindLikeAnyAndTheOthersAreChecked) {
  const ScratchFolder folder;
  const auto& [property, error, signal] = GetParam();
  std::string found;
  for (const char* threads : {"1", "2"}) {
    const Finished run = failed(misbehaving(
        {property, "made_up.holds", "--save", folder.path(), "--seed", "3", "--threads", threads}));
    EXPECT_THAT(run.out, HasSubstr(property + " fails: " + error + ": "));
    EXPECT_THAT(run.out, HasSubstr("made_up.holds"));
    EXPECT_THAT(line_after(run.out, "shrunk: "), testing::StartsWith(error));
    const std::string command = line_after(run.out, "as found: ");
    EXPECT_THAT(command, HasSubstr(" check " + property + " --seed 3 --first "));
    EXPECT_TRUE(found.empty() || command == found) << "on another number of threads";
    found = command;
    const Finished again = failed(shell(command + " --save " + folder.path()));
    EXPECT_EQ(line_after(again.out, "as found: "), command);
    // Of one input there is a debugger's view: it runs in the program itself.
    const Finished least = shell(line_after(run.out, "reproduce: "));
    EXPECT_EQ(least.code, 128 + signal) << least.err;
  }
}

INSTANTIATE_TEST_SUITE_P(
    , CrashingProperty,
    testing::Values(Crash{"made_up.segfaults", "crash SIGSEGV", SIGSEGV},
                    Crash{"made_up.aborts", "crash SIGABRT", SIGABRT},
                    Crash{"made_up.overflows_the_stack", "crash SIGSEGV", SIGSEGV}),
    [](const auto& crash) { return crash.param.property.substr(std::string("made_up.").size()); });

TEST(Check, EveryInputIsCheckedWhateverTheOthersDo) {
  const ScratchFolder folder;
  const Finished run = failed(misbehaving({"made_up.fails_then_aborts", "--count", "120",
                                           "--threads", "1", "--save", folder.path(), "--json"}));
  const auto row = json_lines(run.out).at(0);
  EXPECT_EQ(row.at("checked"), 120);
  EXPECT_EQ(row.at("failed"), 120);
  EXPECT_EQ(row.at("failure"), "before it aborts");
}

TEST(Check, ShrinkingGoesPastWhatCrashesInstead) {
  const ScratchFolder folder;
  const Finished run = failed(misbehaving({"made_up.aborts_when_shrunk", "--save", folder.path()}));
  EXPECT_THAT(run.out, HasSubstr("\nshrunk: a large number\n"));
}

TEST(Check, TheEmptyCounterexampleIsReproducedByTheCommandThatIsPrinted) {
  const ScratchFolder folder;
  const Finished run = failed(misbehaving({"made_up.fails_on_empty", "--save", folder.path()}));
  const std::string command = line_after(run.out, "reproduce: ");
  EXPECT_TRUE(command.ends_with(" check made_up.fails_on_empty --choices ''")) << command;
  const Finished again = failed(shell(command));
  EXPECT_EQ(again.out, "made_up.fails_on_empty fails: the text is empty\n");
  EXPECT_EQ(shell(line_after(run.out, "as found: ") + " --save " + folder.path()).code, 1);
}

TEST(Check, AFindIsSavedAsItIsPrinted) {
  const ScratchFolder folder;
  const Finished run =
      failed(misbehaving({"made_up.fails_on_all", "--save", folder / "new/finds"}));
  const std::string saved = line_after(run.out, "saved: ");
  EXPECT_EQ(saved, folder / "new/finds/made_up.fails_on_all.json");
  const auto find = nlohmann::json::parse(read_text(saved));
  EXPECT_EQ(find.at("text"), "drew 0");
  EXPECT_EQ(find.at("shrunk"), "to the end");
  EXPECT_EQ(find.at("as_found"), line_after(run.out, "as found: "));
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder / "new/finds"), {}), 1)
      << "what was saved before it was shrunk is gone";
  EXPECT_THAT(line_after(run.out, "reproduce: "), testing::EndsWith(" --choices ''"));
}

TEST(Check, AFindThatIsTooLargeToSaveShrunkStaysAsItWasFound) {
  const ScratchFolder folder;
  // Of a block of 512 bytes the shrunk input's text is more, and that of the found one less.
  const Finished run = shell(fmt::format(
      "{{ trap '' XFSZ; ulimit -f 1; {} check made_up.interrupts_when_shrunk --count 1 --save {}; "
      "echo \"exit code $?\"; }} 2>&1 | cat",
      kProgram, folder.path()));
  EXPECT_THAT(run.out, HasSubstr("exit code 130"));
  EXPECT_THAT(run.out, HasSubstr("\nnot saved: "));
  const std::string saved = line_after(run.out, "saved: ");
  EXPECT_EQ(saved, line_after(run.out, "saved as found: "));
  EXPECT_THAT(read_text(saved), HasSubstr("many are large"));
}

TEST(Check, AFailureThatDoesNotRepeatIsAFindThatIsNotShrunk) {
  const ScratchFolder folder;
  const Finished run =
      failed(misbehaving({"made_up.fails_once", "made_up.holds", "--save", folder.path()}));
  EXPECT_THAT(run.out, HasSubstr("made_up.fails_once fails: the first time\n"));
  EXPECT_THAT(run.out, HasSubstr("not shrunk: the same input does not fail each time"));
  EXPECT_THAT(run.out, HasSubstr("made_up.holds"));
  EXPECT_THAT(read_text(line_after(run.out, "saved: ")), HasSubstr("the first time"));
  const Finished json =
      failed(misbehaving({"made_up.fails_once", "--save", folder.path(), "--json"}));
  EXPECT_EQ(json_lines(json.out).at(0).at("fails_again"), false);
}

TEST(Check, ShrinkingEndsWhenItIsInterruptedOrItsTimeIsOver) {
  const ScratchFolder folder;
  const auto shrunk = [&](const std::vector<std::string>& arguments) {
    const Finished run = misbehaving(with(arguments, {"--threads", "1", "--save", folder.path()}));
    EXPECT_THAT(run.out, HasSubstr("\nshrunk (not to the end): many are large\n")) << run.err;
    return run.code;
  };
  EXPECT_EQ(shrunk({"made_up.interrupts_when_shrunk", "--count", "1"}), 130);
  EXPECT_EQ(shrunk({"made_up.is_slow", "--seconds", "0.05"}), 1);
}

TEST(Check, AFindThatCannotBeSavedIsToldAndTheOthersAreChecked) {
  const ScratchFolder folder;
  write_text(folder / "finds", "a file where the folder would be");
  for (const std::string more : {"", " --json"}) {
    const Finished run =
        failed(shell(fmt::format("cd '{}' && {} check made_up.fails_on_all made_up.holds{}",
                                 folder.path(), kProgram, more)));
    EXPECT_THAT(run.out, HasSubstr("drew 0"));
    EXPECT_THAT(run.out, HasSubstr(more.empty() ? "not saved: finds/claims: cannot "
                                                : "\"not_saved\":\"finds/claims: cannot "));
    EXPECT_THAT(run.out, HasSubstr("made_up.holds"));
  }
}

TEST(Check, AFolderThatCannotBeUsedIsRefusedBeforeTheRun) {
  const ScratchFolder folder;
  write_text(folder / "file", "");
  for (const std::string& bad : {std::string(), std::string("/proc/x"), folder / "file"}) {
    const Finished run = misbehaving({"made_up.fails_on_all", "--save", bad});
    EXPECT_EQ(run.code, 2) << bad;
    EXPECT_EQ(run.out, "") << bad;
    EXPECT_THAT(run.err, HasSubstr("--save: " + (bad.empty() ? "\"\"" : bad)));
  }
}

TEST(Check, ARunThatIsInterruptedSaysWhatItDidNotBegin) {
  for (const char* property : {"made_up.interrupts", "made_up.interrupts_and_hangs"}) {
    const Finished run = misbehaving({property, "made_up.holds", "--threads", "1"});
    EXPECT_EQ(run.code, 130) << property;
    EXPECT_THAT(run.err, HasSubstr("interrupted: 1 of 2 properties begun\n")) << property;
  }
}

TEST(Check, FailsWhenNothingIsChecked) {
  const Finished run = failed(misbehaving({"made_up.is_discarded", "made_up.holds"}));
  EXPECT_THAT(run.out, HasSubstr("nothing checked"));
  const Finished json = failed(misbehaving({"made_up.is_discarded", "--json"}));
  const auto rows = json_lines(json.out);
  ASSERT_EQ(rows.size(), 1U);
  EXPECT_EQ(rows[0].at("nothing_checked"), true);
  const Finished by_time =
      failed(misbehaving({"made_up.is_discarded", "--seconds", "1e-9", "--json"}));
  EXPECT_GE(json_lines(by_time.out).at(0).at("discarded"), 1000);
  const Finished one = failed(misbehaving({"made_up.is_discarded", "--choices", "0"}));
  EXPECT_EQ(one.out, "made_up.is_discarded is discarded: the choices make no such input\n");
  EXPECT_EQ(one.err, "ccdfuzz: check: nothing was checked: the input was discarded\n");
}

TEST(Check, AProgramWithABlankInItsPathIsQuotedInWhatIsPrinted) {
  const ScratchFolder folder;
  const std::string program = folder / "a program";
  std::filesystem::create_symlink(kProgram, program);
  const Finished run = failed(
      Process({"check", "made_up.fails_on_all", "--save", folder.path()}, "", program).wait());
  for (const char* beginning : {"reproduce: ", "as found: "}) {
    const std::string command = line_after(run.out, beginning);
    EXPECT_TRUE(command.starts_with("'" + program + "' check ")) << command;
  }
  EXPECT_EQ(shell(line_after(run.out, "reproduce: ")).code, 1);
}

}  // namespace
}  // namespace ccdfuzz
