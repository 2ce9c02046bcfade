// What works in a process apart may do whatever it likes: it is told by its name, and nothing of it
// is left.
#include "method/process_apart.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <ctime>
#include <filesystem>
#include <string>

#include "eval/ask.hpp"
#include "method/method_apart.hpp"
#include "method/process_limits.hpp"

namespace ccdfuzz {
namespace {

using testing::HasSubstr;

/// How many descriptors are open; and whether this process has a child, dead or alive.
std::ptrdiff_t open_descriptors() {
  return std::distance(std::filesystem::directory_iterator("/proc/self/fd"),
                       std::filesystem::directory_iterator());
}
bool has_a_child() {
  return ::waitpid(-1, nullptr, WNOHANG) >= 0 || errno != ECHILD;
}

constexpr double kShortWhile = 0.1;  // CPU seconds
const ApartLimits kPatient{60, 1024}, kShort{kShortWhile, 1024}, kLittleMemory{60, 128};

using Work = std::string (*)();

std::string crash() {
  int* volatile nowhere = nullptr;
  *nowhere = 1;  // NOLINT(clang-analyzer-core.NullDereference)
  return "survived";
}

std::string abort_with_words() {
  std::fputs("this cannot be\n", stderr);
  std::abort();
}

std::string spin() {
  while (true) asm volatile("");
}

std::string wait_for_ever() {
  while (true) ::pause();
}

std::string allocate_without_end() {
  std::string all = "x";
  while (all.size() < std::size_t{1} << 30) all += all;
  return "had enough";
}

std::string fill_most_and_abort() {
  std::string much(80 << 20, 'x');
  abort_with_words();
  return much;
}

std::string close_everything() {
  for (int descriptor = 0; descriptor < 64; ++descriptor) ::close(descriptor);
  return wait_for_ever();
}

struct BadWork {
  const char* what;
  Work work;
  ApartLimits limits;
  const char* name;
  const char* note;
};

void PrintTo(const BadWork& bad, std::ostream* out) {
  *out << bad.what;
}

class ProcessApartFaults : public testing::TestWithParam<BadWork> {};

TEST_P(ProcessApartFaults, IsToldByItsNameAndLeavesNothing) {
  const BadWork& bad = GetParam();
  const std::ptrdiff_t open = open_descriptors();
  const auto done = work_apart(bad.work, bad.limits);
  ASSERT_FALSE(done) << *done;
  EXPECT_EQ(done.error().name(), bad.name) << done.error().what();
  EXPECT_THAT(done.error().what(), HasSubstr(bad.note));
  EXPECT_EQ(open_descriptors(), open);
  EXPECT_FALSE(has_a_child());
}

INSTANTIATE_TEST_SUITE_P(
    Each, ProcessApartFaults,
    testing::Values(
        BadWork{"crash", crash, kPatient, "crash SIGSEGV", "ended by SIGSEGV"},
        BadWork{"abort", abort_with_words, kPatient, "crash SIGABRT", "printed: this cannot be"},
        BadWork{"kill", [] { return std::to_string(::raise(SIGKILL)); }, kPatient, "crash SIGKILL",
                ""},
        BadWork{"spin", spin, kShort, "hang", "no answer within 0.1 s of CPU time"},
        BadWork{"wait", wait_for_ever, {0.02, 1024}, "hang", "no answer within 0.2 s"},
        BadWork{"exit", []() -> std::string { std::_Exit(3); }, kPatient, "exit 3", "exit(3)"},
        BadWork{"close", close_everything, kPatient, "crash SIGKILL", ""},
        BadWork{"fill", fill_most_and_abort, kLittleMemory, "memory", "MiB of its 128 MiB"},
        BadWork{"throw", []() -> std::string { throw std::out_of_range("too far"); }, kPatient,
                "exception", "too far"},
        BadWork{"throw a number", []() -> std::string { throw 1; }, kPatient, "exception",
                "no std::exception"},
        BadWork{"throw a fault", []() -> std::string { throw MethodFault("stale", "two answers"); },
                kPatient, "stale", "two answers"}));

TEST(ProcessApartTest, OutOfMemoryIsToldByItsName) {
  if (kReservesMemory) GTEST_SKIP() << "is not limited under sanitizers";
  const auto done = work_apart(allocate_without_end, kLittleMemory);
  ASSERT_FALSE(done) << done->size();
  EXPECT_EQ(done.error().name(), "memory") << done.error().what();
}

TEST(ProcessApartTest, WhatThisProcessHasOfMemoryIsNotCounted) {
  const std::string own(150 << 20, 'x');
  const auto done = work_apart(abort_with_words, kLittleMemory);
  ASSERT_FALSE(done);
  EXPECT_EQ(done.error().name(), "crash SIGABRT") << done.error().what() << own.back();
  EXPECT_EQ(work_apart([] { return std::string(1 << 20, 'y'); }, kLittleMemory)->size(), 1U << 20);
}

TEST(ProcessApartTest, GivesWhatTheWorkReturnsHoweverLongAndChangesNothingHere) {
  int seen = 0;
  for (const std::size_t size : {std::size_t{0}, std::size_t{1}, std::size_t{1} << 20}) {
    const auto done = work_apart([&] {
      seen = 1;
      std::fputs("printed to nobody\n", stdout);
      std::fflush(stdout);
      return std::string(size, '\0');
    });
    ASSERT_TRUE(done) << done.error().what();
    EXPECT_EQ(*done, std::string(size, '\0'));
  }
  EXPECT_EQ(seen, 0);
  EXPECT_FALSE(has_a_child());
}

TEST(ProcessApartTest, IsToldEvenWhereChildrenAreIgnored) {
  const auto before = ::signal(SIGCHLD, SIG_IGN);
  const auto done = work_apart(abort_with_words, kPatient);
  ::signal(SIGCHLD, before);
  ASSERT_FALSE(done);
  EXPECT_EQ(done.error().name(), "crash SIGABRT");
}

/// Numbers the questions, and does as they say.
std::string number_and_obey(const std::string& question) {
  static int asked = 0;
  ++asked;
  if (question == "crash" || (question == "crash if asked before" && asked > 1)) std::abort();
  return std::to_string(asked);
}

TEST(ProcessApartTest, OneCopyAnswersUntilAFaultAndIsNotAccusedOfWhatOnlyItDoes) {
  const std::ptrdiff_t open = open_descriptors();
  {
    ProcessApart process(number_and_obey, kPatient);
    EXPECT_FALSE(has_a_child()) << "before it is asked";
    EXPECT_EQ(process.ask("1"), "1");
    EXPECT_EQ(process.ask("2"), "2");
    EXPECT_EQ(process.ask("crash if asked before"), "1");
    EXPECT_EQ(process.ask("1"), "2");
    const auto crashed = process.ask("crash");
    ASSERT_FALSE(crashed);
    EXPECT_EQ(crashed.error().name(), "crash SIGABRT");
    EXPECT_FALSE(has_a_child());
    EXPECT_EQ(process.ask("1"), "1");
    EXPECT_TRUE(has_a_child());
  }
  EXPECT_FALSE(has_a_child());
  EXPECT_EQ(open_descriptors(), open);
}

TEST(ProcessApartTest, EveryAnswerHasItsWholeTime) {
  const auto take_half_of_it = [](const std::string& question) {
    const std::clock_t start = std::clock();
    while (std::clock() - start < CLOCKS_PER_SEC / 20) {
    }
    return number_and_obey(question);
  };
  ProcessApart process(take_half_of_it, {0.1, 1024});
  for (int i = 1; i <= 4; ++i) EXPECT_EQ(process.ask(""), std::to_string(i));
}

/// They do at t = 1/2.
Query meeting_points() {
  Query query;
  query.patches[0] = {Shape::point(), {{-0.0, 0, 0x1p-1074}}, {{1, 0, 0}}};
  query.patches[1] = {Shape::point(), {{1, 0, 0x1p-1074}}, {{-1, 0, 0}}};
  return query;
}

/// A method that does and claims what it is told to.
struct MadeUp : Method {
  Answered answer(const Query& query, const SearchOptions& options) override {
    EXPECT_EQ(query, meeting_points());
    ++asked;
    given.seconds = options.max_seconds;
    given.pops = asked;
    return given;
  }

  Answered given;
  std::uint64_t asked = 0;
};

TEST(MethodApart, HandsOnWhatTheMethodSays) {
  auto made = std::make_unique<MadeUp>();
  made->given = {{Verdict::kHit, 0x1.8p-3, {{{0.25, 0.5}, {1, 0}}}, 0, 77, 0, "a note"}};
  made->given.terms.closed_t_max = false;
  made->given.terms.time_tolerance = 1e-9;
  made->given.broken_claim.emplace("nan policy", "said otherwise");
  const auto method = asked_apart(std::move(made), kPatient);
  for (std::uint64_t round = 1; round <= 2; ++round) {
    const Answered answer = method->answer(meeting_points(), {});
    EXPECT_EQ(answer.verdict, Verdict::kHit);
    EXPECT_EQ(answer.toi, 0x1.8p-3);
    EXPECT_EQ(answer.uv[0], (Uv<double>{0.25, 0.5}));
    EXPECT_EQ(answer.uv[1], (Uv<double>{1, 0}));
    EXPECT_EQ(answer.pops, round);
    EXPECT_EQ(answer.bytes, 77U);
    EXPECT_EQ(answer.note, "a note");
    EXPECT_EQ(answer.seconds, 10) << "of 60 s";
    EXPECT_FALSE(answer.terms.closed_t_max);
    EXPECT_EQ(answer.terms.time_tolerance, 1e-9);
    EXPECT_EQ(answer.broken_claim->name(), "nan policy");
    EXPECT_STREQ(answer.broken_claim->what(), "said otherwise");
  }
  SearchOptions hurried;
  hurried.max_seconds = 1;
  EXPECT_EQ(method->answer(meeting_points(), hurried).seconds, 1);
  EXPECT_TRUE(method->runs_elsewhere());
}

TEST(MethodApart, AnswersAsHere) {
  const Query query = meeting_points();
  for (const char* spec : {"trad", "tdibm", "tdibm-rational", "oracle"}) {
    const Answer here = (*make_method(spec))->answer(query, {});
    const Answer there = (*make_method_apart(spec))->answer(query, {});
    EXPECT_EQ(there.verdict, here.verdict) << spec;
    EXPECT_EQ(there.toi, here.toi) << spec;
    EXPECT_EQ(there.uv, here.uv) << spec;
    EXPECT_EQ(there.pops, here.pops) << spec;
    EXPECT_EQ(there.note, here.note) << spec;
  }
}

struct Crashing : Method {
  Answered answer(const Query&, const SearchOptions&) override { std::abort(); }
};

TEST(MethodApart, CrashIsAnErrorLikeAny) {
  const auto method = asked_apart(std::make_unique<Crashing>());
  Case known;
  known.query = meeting_points();
  const Judged judged = ask(*method, known, {});
  EXPECT_EQ(judged.outcome, Outcome::kError);
  EXPECT_EQ(judged.error, "crash SIGABRT");
  EXPECT_EQ(judged.answer.verdict, Verdict::kUndecided);
}

}  // namespace
}  // namespace ccdfuzz
