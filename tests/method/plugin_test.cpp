#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <sstream>

#include "admitted.hpp"
#include "base/no_process.hpp"
#include "meeting_points.hpp"
#include "method/method.hpp"
#include "method/plugin/plugin_method.hpp"
#include "scratch_folder.hpp"

namespace ccdfuzz {
namespace {

const std::string kMisbehaving = std::string("plugin:") + CCDFUZZ_TEST_MISBEHAVING_PLUGIN;
const std::string kMisbehavingProgram =
    std::string("plugin-exec:") + CCDFUZZ_TEST_MISBEHAVING_PROGRAM;
const std::string kLinear = std::string("plugin:") + CCDFUZZ_TEST_LINEAR_PLUGIN;
const std::string kNaive = std::string("plugin:") + CCDFUZZ_TEST_NAIVE_PLUGIN;

/// A program of a shell; its spec.
std::string program(const std::string& path, const std::string& text) {
  write_text(path, "#!/bin/sh\n" + text);
  std::filesystem::permissions(path, std::filesystem::perms::owner_all);
  return "plugin-exec:" + path;
}

std::unique_ptr<Method> made(const std::string& spec) {
  return value_or_throw(admitted(spec));
}

/// By what name a plug-in fails, or "" if it answers; and why.
std::pair<std::string, std::string> fault_of(Method& method) {
  try {
    method.answer(falling_vertex(), {});
    return {"", ""};
  } catch (const MethodFault& fault) {
    return {fault.name(), fault.what()};
  }
}

/// Options with a time limit that only a hang reaches, however busy the machine is.
std::string patient(const std::string& options) {
  return options.find("seconds=") == std::string::npos ? options + ":seconds=30" : options;
}

struct Misdeed {
  const char* options;
  const char* name;
  const char* note;
};

void PrintTo(const Misdeed& misdeed, std::ostream* out) {
  *out << misdeed.options;
}

/// It is reported by its name, again and again, and the method can still be asked.
void expect_fault(const std::string& plugin, const Misdeed& misdeed) {
  const auto method = made(plugin + ":" + patient(misdeed.options));
  for (int round = 0; round < 2; ++round) {
    const auto [name, note] = fault_of(*method);
    EXPECT_EQ(name, misdeed.name) << note;
    EXPECT_THAT(note, testing::HasSubstr(misdeed.note));
  }
}

class PluginFaults : public testing::TestWithParam<Misdeed> {};
TEST_P(PluginFaults, HaveNamesInALibrary) {
  expect_fault(kMisbehaving, GetParam());
}

INSTANTIATE_TEST_SUITE_P(
    Each, PluginFaults,
    testing::Values(Misdeed{"crash", "crash SIGSEGV", ""}, Misdeed{"abort", "crash SIGABRT", ""},
                    Misdeed{"exit", "exit 7", "exit(7)"},
                    Misdeed{"throw", "exception", "thrown by a plug-in"},
                    Misdeed{"hang:seconds=0.2", "hang", "within 0.2 s"},
                    Misdeed{"spin:seconds=0.2", "hang", "within 0.2 s"},
                    Misdeed{"memory:mb=200:seconds=20", "memory", ""},
                    Misdeed{"malloc:mb=200:seconds=20", "memory", ""},
                    Misdeed{"print:seconds=20", "output", "prints without end"},
                    Misdeed{"silent", "unanswered", ""}, Misdeed{"nan", "toi NaN", ""},
                    Misdeed{"half", "uv NaN", ""}, Misdeed{"no-toi", "toi infinite", ""},
                    Misdeed{"outside", "toi outside", "2"},
                    Misdeed{"negative", "toi outside", "-1"}, Misdeed{"backwards", "toi order", ""},
                    Misdeed{"verdict", "garbage", "99"}, Misdeed{"small", "sizes", "4 bytes"},
                    Misdeed{"large", "sizes", ""}, Misdeed{"overrun", "sizes", "past the end"},
                    Misdeed{"query", "sizes", "into the query"}, Misdeed{"error", "error", ""},
                    Misdeed{"status", "error", "-1"},
                    Misdeed{"stale", "two answers", "hit at 0.5, then hit at 0.25"}));

class ProgramFaults : public testing::TestWithParam<Misdeed> {};
TEST_P(ProgramFaults, HaveNames) {
  expect_fault(kMisbehavingProgram, GetParam());
}

INSTANTIATE_TEST_SUITE_P(
    Each, ProgramFaults,
    testing::Values(Misdeed{"garbage", "garbage", "Traceback"}, Misdeed{"nan", "toi NaN", ""},
                    Misdeed{"inf", "toi infinite", ""}, Misdeed{"stale", "stale", ""},
                    Misdeed{"by turns", "two answers", "hit at 0, then miss"},
                    Misdeed{"another uv", "two answers", "hit at 0 with another uv"},
                    Misdeed{"chatty", "stale", ""}, Misdeed{"long", "output", ""},
                    Misdeed{"exit", "exit 3", "gave up"}, Misdeed{"kill", "crash SIGKILL", ""},
                    Misdeed{"hang:seconds=5", "hang", ""}, Misdeed{"close", "garbage", ""},
                    Misdeed{"memory:mb=500", "exit 1", "MemoryError"},
                    Misdeed{"word", "garbage", "maybe"}, Misdeed{"no toi", "toi missing", ""},
                    Misdeed{"says toi \"0.5\"", "garbage", "hit at \"0.5\", which is no time"},
                    Misdeed{"says verdict \"HIT\"", "garbage", "none of hit, miss, inconclusive"},
                    Misdeed{"says id null", "stale", "the id null when asked"},
                    Misdeed{"says toi [0,Infinity]", "toi infinite", "until the time inf"},
                    Misdeed{"says toi [0,\"soon\"]", "garbage", "until \"soon\""},
                    Misdeed{"says toi [0.5,0.25]", "toi order", ""},
                    Misdeed{"says iterations -1", "garbage", "iterations -1"},
                    Misdeed{"says iterations 0.5", "garbage", "iterations 0.5"},
                    Misdeed{"says bytes 1e300", "garbage", "bytes 1e+300"},
                    Misdeed{"says seconds -1", "garbage", "seconds -1"},
                    Misdeed{"says seconds Infinity", "garbage", "seconds \"Infinity\""},
                    Misdeed{"says tolerance \"small\"", "garbage", "tolerance \"small\""},
                    Misdeed{"says uv \"here\"", "garbage", "uv is not"},
                    Misdeed{"says uv [[0,0]]", "garbage", "uv is not"},
                    Misdeed{"says id 1.5", "stale", "1.5"}));

TEST(Plugin, IsBadInputWhenItFailsToSayWhatItIs) {
  ::setenv("CCDFUZZ_TEST_LYING_TABLE", "1", 1);
  const auto lying = admit_plugin(kMisbehaving + ":table");
  ::unsetenv("CCDFUZZ_TEST_LYING_TABLE");
  EXPECT_THAT(lying.error().message(), testing::HasSubstr("sizes when asked what it is"));
  for (const char* options :
       {"pairs", "describe-size", "describe-crash", "describe-exit", "describe-hang:seconds=0.2"}) {
    const auto refused = admit_plugin(kMisbehaving + ":" + patient(options));
    EXPECT_THAT(refused.error().message(), testing::HasSubstr(" when asked what it is: "));
  }
  EXPECT_TRUE(admit_plugin(kMisbehaving + ":describe-sleep"));  // 5 s of the 10 that it has
}

TEST(Plugin, IsAskedNoMoreAfterRepeatedHangs) {
  const auto method = made(kMisbehaving + ":hang:seconds=0.02");
  for (int i = 0; i < 8; ++i) EXPECT_EQ(fault_of(*method).first, "hang");
  const Answer answer = method->answer(falling_vertex(), {});
  EXPECT_EQ(answer.verdict, Verdict::kUndecided);
  EXPECT_THAT(answer.note, testing::HasSubstr("asked no more"));
}

TEST(Plugin, IsAskedNothingMoreOfAQueryOnceItsTimeIsOver) {
  const auto method = made(kMisbehaving + ":stale:seconds=30");
  SearchOptions options;
  options.max_seconds = 0;
  EXPECT_EQ(method->answer(falling_vertex(), options).verdict, Verdict::kHit);
  EXPECT_EQ(fault_of(*made(kMisbehaving + ":stale:seconds=30")).first, "two answers");
}

TEST(Plugin, IsToldItsOptionsAndNotThoseOfTheHost) {
  EXPECT_FALSE(admitted(kMisbehaving + ":mb=100:refuse"));
  EXPECT_TRUE(admitted(kMisbehaving + ":refuse:other"));
}

TEST(Plugin, AnswersInEitherOrderOfThePatches) {
  const auto method = made(kLinear);
  Query query = falling_vertex(0.25, 0.5);
  Answer answer = method->answer(query, {});
  ASSERT_EQ(answer.verdict, Verdict::kHit);
  EXPECT_NEAR(*answer.toi, 0.5, 1e-12);
  EXPECT_NEAR(answer.uv[1][0], 0.25, 1e-12);
  EXPECT_NEAR(answer.uv[1][1], 0.5, 1e-12);
  std::swap(query.patches[0], query.patches[1]);
  answer = method->answer(query, {});
  ASSERT_EQ(answer.verdict, Verdict::kHit);
  EXPECT_NEAR(answer.uv[0][0], 0.25, 1e-12);
  EXPECT_NEAR(answer.uv[0][1], 0.5, 1e-12);
}

TEST(Plugin, IsNotAskedAboutShapesThatItDoesNotTakeNorWhatIsNotValid) {
  const auto naive = made(kNaive);
  Query query = falling_vertex();
  EXPECT_EQ(naive->answer(query, {}).note, "does not take point and triangle(1)");
  query.patches[1].positions[0][0] = std::numeric_limits<double>::quiet_NaN();
  const Answer answer = naive->answer(query, {});
  EXPECT_EQ(answer.verdict, Verdict::kRefused);
  EXPECT_EQ(answer.note, "patches[1].positions[0][0]: nan is not finite");
}

TEST(Plugin, MayBeBuiltWithADescriptionThatHadFewerFields) {
  const std::string old = kMisbehaving + ":old";
  ASSERT_TRUE(admit_plugin(old));
  EXPECT_EQ(method_info(old)->description, "misbehaving");
}

TEST(Plugin, SaysWhatItIsAndClaims) {
  ASSERT_TRUE(admit_plugin(kNaive));
  ASSERT_TRUE(admit_plugin(kMisbehaving + ":nan"));
  const auto naive = method_info(kNaive);
  EXPECT_EQ(naive->description, "naive Newton 1.0");
  EXPECT_FALSE(naive->claims_no_false_negative);
  EXPECT_TRUE(method_info(kMisbehaving + ":nan")->claims_no_false_negative);
  const Answered answered = made(kLinear)->answer(falling_vertex(), {});
  EXPECT_EQ(answered.terms.time_tolerance, 1e-12);
  EXPECT_TRUE(answered.has_uv);
}

// A file may hold any spec: looking it up must start nothing.
TEST(Plugin, StartsOnlyOnceItIsAdmitted) {
  const ScratchFolder folder;
  const std::string spec = program(folder / "trap", "touch " + (folder / "sprung") + "\n");
  EXPECT_FALSE(is_admitted(spec));
  for (const std::string& message :
       {make_method(spec).error().message(), method_info(spec).error().message()}) {
    EXPECT_THAT(message, testing::HasSubstr("\"" + spec + "\""));
  }
  EXPECT_FALSE(std::filesystem::exists(folder / "sprung"));
  EXPECT_FALSE(admit_plugin(spec)) << "it does not say what it is";
  EXPECT_TRUE(std::filesystem::exists(folder / "sprung")) << "the trap works";
  EXPECT_TRUE(is_admitted("tdibm-c"));
}

TEST(Plugin, IsAtFaultWhenItRefusesToBeStartedAgain) {
  const ScratchFolder folder;
  const auto once = made(program(
      folder / "once", "read line\nif [ -e " + (folder / "started") +
                           " ]; then echo '{\"refused\":\"options\",\"message\":\"not again\"}'; "
                           "exit; fi\ntouch " +
                           (folder / "started") + "\necho '{\"protocol\":1}'\n"));
  EXPECT_EQ(fault_of(*once),
            std::pair(std::string("refused"), std::string("when asked what it is: not again")));
  std::filesystem::remove(folder / "once");
  EXPECT_THROW(fault_of(*once), NoProcess) << "its file may be there again in a moment";
}

TEST(Plugin, IsAtFaultWhenItDescribesItselfOtherwiseWhenItIsStartedAgain) {
  const ScratchFolder folder;
  const auto fickle = made(program(
      folder / "fickle",
      "read line\necho x >> " + (folder / "starts") + "\nn=$(wc -l < " + (folder / "starts") +
          ")\necho '{\"protocol\":1,\"name\":\"same\",\"version\":\"'$n'\"}'\nread line\n"));
  for (const char* change : {R"(version ("1", then "2"))", R"(version ("1", then "3"))"}) {
    const auto [name, note] = fault_of(*fickle);
    EXPECT_EQ(name, "description");
    EXPECT_EQ(note, std::string("describes itself otherwise when it is started again: ") + change);
  }
  EXPECT_EQ(changes_between(R"({"protocol":1,"within":7})", R"({"protocol":1,"accepts":[]})"),
            "accepts (nothing, then an array), within (7, then nothing)");
  EXPECT_EQ(changes_between(R"({"protocol":1,"within":7})", R"({"within":7, "protocol":1})"), "");
}

TEST(Plugin, IsBadInputWhenItRefusesToStartOrItsFileIsNone) {
  const ScratchFolder folder;
  const std::string spec =
      program(folder / "silent", "read line\necho '{\"refused\":\"options\"}'\n");
  EXPECT_EQ(admit_plugin(spec).error().message(),
            "method: \"" + spec + "\": refuses to start, and does not say why");
  write_text(folder / "text", "no library\n");
  write_text(folder / "mute", "#!/bin/sh\n");
  for (const std::string& none :
       {std::string("plugin:"), "plugin:" + folder.path(), "plugin:" + (folder / "nothing"),
        "plugin:" + (folder / "text"), "plugin-exec:" + (folder / "mute"),
        std::string("plugin:/usr/bin/env"), kLinear + ":unknown-option", kNaive + ":seconds=-1",
        kNaive + ":seconds=x", kNaive + ":mb=1", kNaive + ":repeat=maybe"}) {
    const auto refused = admit_plugin(none);
    ASSERT_FALSE(refused) << none;
    EXPECT_THAT(refused.error().message(), testing::HasSubstr("\"" + none + "\""));
  }
  EXPECT_THAT(admit_plugin("plugin:" + (folder / "text")).error().message(),
              testing::HasSubstr("a program is plugin-exec:PATH"));
  EXPECT_THAT(make_method(folder / "text").error().message(),
              testing::HasSubstr("did you mean plugin-exec:" + (folder / "text") + "?"));
}

/// Whether a process is there; one that has ended but that nobody looked after yet is not.
bool lives(pid_t pid) {
  const std::string stat = read_text("/proc/" + std::to_string(pid) + "/stat");
  return !stat.empty() && stat.find(") Z ") == std::string::npos;
}

TEST(Plugin, LeavesNoProcessBehindThatItStarted) {
  pid_t left = 0;
  {
    const auto method = made(kMisbehaving + ":leave:repeat=no:seconds=30");
    left = static_cast<pid_t>(method->answer(falling_vertex(), {}).pops);
    EXPECT_TRUE(lives(left));
  }
  EXPECT_FALSE(lives(left));
  const auto [name, note] = fault_of(*made(kMisbehaving + ":leave-and-exit:seconds=30"));
  EXPECT_EQ(name, "exit 7") << note;
  const std::string printed = "it printed: ";
  ASSERT_NE(note.find(printed), std::string::npos) << note;
  EXPECT_FALSE(lives(std::stoi(note.substr(note.find(printed) + printed.size()))));
}

/// Processes of this name.
size_t count_of(const std::string& name) {
  size_t count = 0;
  for (const auto& entry : std::filesystem::directory_iterator("/proc")) {
    if (read_text(entry.path() / "comm") == name + "\n") ++count;
  }
  return count;
}

TEST(Plugin, LeavesNothingOfAThousandProcessesThatItStarted) {
  {
    const auto method = made(kMisbehaving + ":crowd:repeat=no:seconds=60");
    EXPECT_EQ(method->answer(falling_vertex(), {}).pops, 1000U);
    EXPECT_TRUE(comes_to_hold([] { return count_of("ccdfuzz-crowd") == 1000; })) << "by name";
  }
  EXPECT_EQ(count_of("ccdfuzz-crowd"), 0U);
}

class PluginSupervisor : public testing::TestWithParam<const char*> {};

TEST_P(PluginSupervisor, LeavesNoProcessWhenItIsKilledAndTheErrorIsReported) {
  const std::string whom = GetParam();
  const auto [name, note] =
      fault_of(*made(kMisbehavingProgram + ":murder " + whom + ":repeat=no:seconds=15"));
  EXPECT_EQ(name, "crash SIGKILL") << note;
  std::istringstream printed(note.substr(note.rfind(':') + 1));
  std::vector<pid_t> left;
  for (pid_t pid = 0; printed >> pid;) left.push_back(pid);
  EXPECT_EQ(left.size(), 2U) << note;
  for (const pid_t pid : left) {
    // Of both: nobody is there any more who knows what it has started.
    EXPECT_TRUE(whom == "both" || comes_to_hold([pid] { return !lives(pid); })) << pid;
    if (lives(pid)) ::kill(pid, SIGKILL);
  }
}

INSTANTIATE_TEST_SUITE_P(Each, PluginSupervisor,
                         testing::Values("parent", "group", "grandparent", "both"));

TEST(Plugin, EndsAsItDidWhereSigchldIsIgnored) {
  const auto before = std::signal(SIGCHLD, SIG_IGN);
  const auto [name, note] = fault_of(*made(kMisbehaving + ":exit:seconds=30"));
  EXPECT_EQ(name, "exit 7") << note;
  std::signal(SIGCHLD, SIG_IGN);
  EXPECT_EQ(fault_of(*made(kMisbehavingProgram + ":exit:seconds=30")).first, "exit 3");
  std::signal(SIGCHLD, before);
}

TEST(Plugin, LeavesNoProcessBehind) {
  const std::string self = std::to_string(::getpid());
  const auto children = [&] { return read_text("/proc/self/task/" + self + "/children"); };
  const std::string before = children();
  {
    const auto method = made(kNaive);
    method->answer(falling_vertex(), {});
    EXPECT_EQ(fault_of(*made(kMisbehaving + ":hang:seconds=0.05")).first, "hang");
    const auto linear = made(kLinear);
    linear->answer(falling_vertex(), {});
    EXPECT_NE(children(), before);
  }
  EXPECT_EQ(children(), before);
}

}  // namespace
}  // namespace ccdfuzz
