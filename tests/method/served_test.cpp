// Work in a child may do whatever it likes: the error has its name, and nothing of it is
// left.
#include "io/serve.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <filesystem>
#include <map>
#include <string>
#include <thread>

#include "certify/checker/check_case.hpp"
#include "io/process_limits.hpp"
#include "method/ask.hpp"
#include "method/served_method.hpp"
#include "served_by_test.hpp"

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

const ChildLimits kPatient{600, 60, 1024}, kShort{60, 0.1, 1024}, kLittleMemory{600, 60, 256};

/// What a child says.
struct Said {
  std::string text;

  static void fields(auto& archive, auto& said) { archive("text", said.text); }
};

using Work = std::string (*)(const std::string&);

std::string crash(const std::string&) {
  int* volatile nowhere = nullptr;
  *nowhere = 1;  // NOLINT(clang-analyzer-core.NullDereference)
  return "survived";
}

std::string abort_with_words(const std::string&) {
  std::fputs(("it began" + std::string(1000, 'x') + "\nthis cannot be\n").c_str(), stderr);
  std::abort();
}

std::string spin(const std::string&) {
  while (true) asm volatile("");
}

std::string wait_for_ever(const std::string&) {
  while (true) ::pause();
}

std::string allocate_without_end(const std::string&) {
  std::string all = "x";
  while (all.size() < std::size_t{1} << 30) all += all;
  return "had enough";
}

std::string fill_most_and_abort(const std::string& question) {
  std::string much(160 << 20, 'x');
  abort_with_words(question);
  return much;
}

std::string close_everything(const std::string& question) {
  for (int descriptor = 0; descriptor < 128; ++descriptor) ::close(descriptor);
  return wait_for_ever(question);
}

/// This many bytes, after words that nobody reads.
std::string repeat(const std::string& question) {
  std::fputs("printed to nobody\n", stdout);
  return to_json(Said{std::string(std::stoul(question), 'y')});
}

/// Numbers the questions, and does as they say.
std::string number_and_obey(const std::string& question) {
  static int asked = 0;
  ++asked;
  if (question == "crash" || (question == "crash if asked before" && asked > 1)) std::abort();
  return to_json(Said{std::to_string(asked)});
}

std::string take_half_of_the_time(const std::string& question) {
  const std::clock_t start = std::clock();
  while (std::clock() - start < CLOCKS_PER_SEC / 20) {
  }
  return number_and_obey(question);
}

const std::map<std::string, Work> kWorks = {
    {"crash", crash},
    {"abort", abort_with_words},
    {"kill", [](const std::string&) { return std::to_string(::raise(SIGKILL)); }},
    {"spin", spin},
    {"wait", wait_for_ever},
    {"exit", [](const std::string&) -> std::string { std::_Exit(3); }},
    {"close", close_everything},
    {"fill", fill_most_and_abort},
    {"grow", allocate_without_end},
    {"throw", [](const std::string&) -> std::string { throw std::out_of_range("too far"); }},
    {"throw a number", [](const std::string&) -> std::string { throw 1; }},
    {"say nothing", [](const std::string&) { return std::string("{}"); }},
    {"repeat", repeat},
    {"number", number_and_obey},
    {"take half", take_half_of_the_time}};

struct Aborting : Method {
  Answered answer(const Query&, const SearchOptions&) override { std::abort(); }
};

/// Answers with the line that it got.
struct Echoing : Method {
  Answered answer(const Query& query, const SearchOptions& options) override {
    Answered given{Answer::hit(query.t_max)};
    given.uv = {{{0.25, 0.5}, {1, -0.0}}};
    given.note = "\"work\": " + std::to_string(options.max_work);
    given.pops = options.max_pops;
    given.bytes = options.max_bytes;
    given.seconds = std::min(options.max_seconds, 1e9);  // more is no time of an answer
    return given;
  }
};

/// `serve [--cpu-seconds S] WORK`, a made-up method, or one of ours.
void serve_works(int argc, char** argv) {
  if (argc < 2 || std::string(argv[1]) != "serve") return serve_by_this_program();
  const std::string name = argv[argc - 1];
  const double cpu_seconds = argc > 3 ? std::stod(argv[3]) : 0;
  if (const auto work = kWorks.find(name); work != kWorks.end()) {
    serve_lines(work->second, cpu_seconds);
  }
  std::unique_ptr<Method> method;
  if (name == "aborts") method = std::make_unique<Aborting>();
  if (name == "echoes") method = std::make_unique<Echoing>();
  if (!method) method = *make_method(name);
  serve_lines([&](const std::string& question) { return served_answer(name, *method, question); },
              cpu_seconds);
}

[[maybe_unused]] const bool serves = (served_by_test = serve_works, true);

tl::expected<Said, Fault> asked(Child& child, const std::string& question) {
  return ask_served<Said>(child, question);
}

tl::expected<Said, Fault> asked_once(const std::string& work, const ChildLimits& limits,
                                     const std::string& question = "") {
  Child child(*served_child({work}, limits));
  return asked(child, question);
}

struct BadWork {
  const char* work;
  ChildLimits limits;
  const char* name;
  std::string note;
};

void PrintTo(const BadWork& bad, std::ostream* out) {
  *out << bad.work;
}

class ServedFaults : public testing::TestWithParam<BadWork> {};

TEST_P(ServedFaults, AreToldByTheirNamesAndLeaveNothing) {
  const BadWork& bad = GetParam();
  const std::ptrdiff_t open = open_descriptors();
  const auto done = asked_once(bad.work, bad.limits);
  ASSERT_FALSE(done) << done->text;
  EXPECT_EQ(done.error().name, bad.name) << done.error().note;
  EXPECT_THAT(done.error().note, HasSubstr(bad.note));
  EXPECT_EQ(open_descriptors(), open);
  EXPECT_FALSE(has_a_child());
}

INSTANTIATE_TEST_SUITE_P(
    Each, ServedFaults,
    testing::Values(BadWork{"crash", kPatient, "crash SIGSEGV", "ended by SIGSEGV"},
                    BadWork{"abort", kPatient, "crash SIGABRT",
                            "printed: it began" + std::string(192, 'x') + " [...] " +
                                std::string(284, 'x') + " this cannot be"},
                    BadWork{"kill", kPatient, "crash SIGKILL", ""},
                    BadWork{"spin", kShort, "hang", "no answer within 0.1 s of CPU time"},
                    BadWork{"wait", {0.5, 60, 1024}, "hang", "no answer within 0.5 s"},
                    BadWork{"exit", kPatient, "exit 3", "exit(3)"},
                    BadWork{"close", kPatient, "garbage", "closed its output"},
                    BadWork{"throw", kPatient, "exception", "too far"},
                    BadWork{"throw a number", kPatient, "exception", "no std::exception"},
                    BadWork{"say nothing", kPatient, "garbage", "text"}));

TEST(Served, WantOfMemoryIsToldByItsName) {
  if (kReservesMemory) GTEST_SKIP() << "is not limited under sanitizers";
  for (const char* work : {"grow", "fill"}) {
    const auto done = asked_once(work, kLittleMemory);
    ASSERT_FALSE(done) << done->text.size();
    EXPECT_EQ(done.error().name, "memory") << done.error().note;
  }
}

TEST(Served, DoesNotCountTheMemoryOfThisProcess) {
  const std::string own(300 << 20, 'x');
  const auto done = asked_once("abort", kLittleMemory);
  ASSERT_FALSE(done);
  EXPECT_EQ(done.error().name, "crash SIGABRT") << done.error().note << own.back();
}

TEST(Served, AnAnswerMayBeOfAnyLength) {
  Child child(*served_child({"repeat"}, kPatient));
  for (const std::size_t size : {std::size_t{0}, std::size_t{1}, std::size_t{1} << 20}) {
    const auto done = asked(child, std::to_string(size));
    ASSERT_TRUE(done) << done.error().note;
    EXPECT_EQ(done->text, std::string(size, 'y'));
  }
}

TEST(Served, OneChildAnswersUntilAFaultAndIsNotAccusedOfWhatOnlyItDoes) {
  const std::ptrdiff_t open = open_descriptors();
  {
    Child child(*served_child({"number"}, kPatient));
    EXPECT_FALSE(has_a_child()) << "before it is asked";
    EXPECT_EQ(asked(child, "1")->text, "1");
    EXPECT_EQ(asked(child, "2")->text, "2");
    EXPECT_EQ(asked(child, "crash if asked before")->text, "1");
    EXPECT_EQ(asked(child, "1")->text, "2");
    const auto crashed = asked(child, "crash");
    ASSERT_FALSE(crashed);
    EXPECT_EQ(crashed.error().name, "crash SIGABRT");
    EXPECT_FALSE(has_a_child());
    EXPECT_EQ(asked(child, "1")->text, "1");
    EXPECT_TRUE(has_a_child());
  }
  EXPECT_FALSE(has_a_child());
  EXPECT_EQ(open_descriptors(), open);
}

TEST(Served, EveryAnswerHasItsWholeTime) {
  Child child(*served_child({"take half"}, kShort));
  for (int i = 1; i <= 4; ++i) EXPECT_EQ(asked(child, "")->text, std::to_string(i));
}

TEST(Served, AnyThreadMayAskAtAnyTime) {
  std::vector<std::thread> threads;
  std::array<std::string, 4> texts;
  for (std::string& text : texts) {
    threads.emplace_back([&text] {
      for (int i = 0; i < 5; ++i) text += asked_once("number", kPatient)->text;
    });
  }
  for (std::thread& thread : threads) thread.join();
  for (const std::string& text : texts) EXPECT_EQ(text, "11111");
}

/// They do at t = 1/2.
Query tiny_meeting_points() {
  Query query;
  query.patches[0] = {Shape::point(), {{-0.0, 0, 0x1p-1074}}, {{1, 0, 0}}};
  query.patches[1] = {Shape::point(), {{1, 0, 0x1p-1074}}, {{-1, 0, 0}}};
  return query;
}

TEST(ServedMethod, IsAskedAndAnswersWithoutALoss) {
  const auto method = *served_method("echoes", kPatient);
  for (const std::uint64_t pops : {3, 1'000'000}) {
    Query query = tiny_meeting_points();
    query.t_max = 0x1.8p-1073;
    const SearchOptions options{.max_pops = pops, .max_bytes = 5 << 20, .max_work = 7};
    const Answered answer = method->answer(query, options);
    EXPECT_EQ(answer.verdict, Verdict::kHit);
    EXPECT_EQ(answer.toi, query.t_max);
    EXPECT_EQ(answer.uv[0], (Uv<double>{0.25, 0.5}));
    EXPECT_EQ(answer.uv[1], (Uv<double>{1, 0}));
    EXPECT_TRUE(std::signbit(answer.uv[1][1]));
    EXPECT_EQ(answer.pops, pops);
    EXPECT_EQ(answer.bytes, 5U << 20);
    EXPECT_EQ(answer.note, "\"work\": 7");
    EXPECT_EQ(answer.seconds, 1e9) << "is told no limit of time but the caller's";
    EXPECT_TRUE(answer.terms.closed_t_max);
    EXPECT_EQ(answer.terms.time_tolerance, 0);
    EXPECT_FALSE(answer.broken_claim);
  }
  SearchOptions hurried;
  hurried.max_seconds = 1;
  EXPECT_EQ(method->answer(tiny_meeting_points(), hurried).seconds, 1);
  EXPECT_TRUE(method->runs_elsewhere());
}

TEST(ServedMethod, AnswersAsHere) {
  const Query query = tiny_meeting_points();
  const SearchOptions full, cut{.max_pops = 1};
  for (const char* spec : {"trad", "tdibm", "tdibm-rational", "oracle"}) {
    const auto served = *make_served_method(spec);
    for (const SearchOptions& options : {full, cut}) {
      const Answer here = (*make_method(spec))->answer(query, options);
      const Answer there = served->answer(query, options);
      EXPECT_EQ(there.verdict, here.verdict) << spec;
      EXPECT_EQ(there.toi, here.toi) << spec;
      EXPECT_EQ(there.uv, here.uv) << spec;
      EXPECT_EQ(there.pops, here.pops) << spec;
      EXPECT_EQ(there.bytes, here.bytes) << spec;
      EXPECT_EQ(there.note, here.note) << spec;
    }
  }
}

TEST(ServedMethod, CrashIsAnErrorLikeAny) {
  const auto method = *served_method("aborts", kPatient);
  Case known;
  known.query = tiny_meeting_points();
  const Judged judged = ask(*method, checked_or_unknown(known), {});
  EXPECT_EQ(judged.outcome, Outcome::kError);
  EXPECT_EQ(judged.error, "crash SIGABRT");
  EXPECT_EQ(judged.answer.verdict, Verdict::kUndecided);
}

}  // namespace
}  // namespace ccdfuzz
