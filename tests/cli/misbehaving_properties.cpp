// `ccdfuzz check` and `ccdfuzz triage` of made-up properties, each of which misbehaves as its name
// says.
#include <sys/time.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <string>
#include <thread>

#include "cli/command.hpp"
#include "hunt/serve.hpp"
#include "properties/suites.hpp"

namespace ccdfuzz {
namespace {

void holds(Draw& choices) {
  choices.choose(9);
}

/// True of every input with a byte of text; the counterexample is the empty one.
void fails_on_empty(Draw& choices) {
  if (choices.text(8).empty()) throw Refuted("the text is empty");
}

/// Shrinks to the byte 0.
void fails_on_all(Draw& choices) {
  throw Refuted("drew " + std::to_string(choices.choose(1) == 0 ? 0 : 1));
}

void is_discarded(Draw& choices) {
  choices.choose(9);
  throw Discarded();
}

bool one_in_a_hundred(Draw& choices) {
  return choices.choose(std::uint64_t{1} << 40) % 100 == 99;
}

void segfaults(Draw& choices) {
  if (one_in_a_hundred(choices)) std::raise(SIGSEGV);
}

void aborts(Draw& choices) {
  if (one_in_a_hundred(choices)) std::abort();
}

/// More than any process is given.
void wants_memory(Draw& choices) {
  std::vector<std::string> all;
  while (one_in_a_hundred(choices)) all.emplace_back(std::size_t{1} << 40, 'x');
}

/// Deeper than any stack; the sum keeps the calls from becoming a loop.
int depth(volatile int* below) {
  volatile int here[64] = {*below + 1};
  return here[0] == 1'000'000'000 ? 0 : depth(here) + here[0];
}

void overflows_the_stack(Draw& choices) {
  volatile int none = 0;
  if (one_in_a_hundred(choices)) none = depth(&none);
}

/// Fails on large numbers, and aborts on what they are shrunk to.
void aborts_when_shrunk(Draw& choices) {
  const std::uint64_t number = choices.choose(std::uint64_t{1} << 40);
  if (number > 1000) throw Refuted("a large number");
  if (number > 500) std::abort();
}

/// Whoever checks, not the child that this runs in.
void interrupt_who_checks() {
  ::kill(std::atoi(std::getenv("MISBEHAVING_PROPERTIES")), SIGINT);
}

void interrupts_and_hangs(Draw&) {
  interrupt_who_checks();
  for (;;) std::this_thread::sleep_for(std::chrono::seconds(1000));
}

void hangs(Draw& choices) {
  if (!one_in_a_hundred(choices)) return;
  std::cout << "hanging" << std::endl;  // NOLINT: whoever waits for it must see it
  for (;;) std::this_thread::sleep_for(std::chrono::seconds(1000));
}

/// The timer of a child that hangs ends this one soon. A line of the file "hangs" for each time.
void hangs_soon() {
  std::ofstream("hangs", std::ios::app) << "hangs\n";
  const itimerval soon = {{0, 0}, {0, 100'000}};
  ::setitimer(ITIMER_PROF, &soon, nullptr);
}

void draws_without_end(Draw& choices) {
  hangs_soon();
  for (;;) choices.choose(9);
}

void refuses_all_draws(Draw& choices) {
  hangs_soon();
  choices.until([&] { return choices.choose(9); }, [](std::uint64_t) { return false; });
}

/// Takes more tries than stored choices are given.
void fails_on_what_is_rare(Draw& choices) {
  const auto number = [&] { return choices.choose(1'000'000); };
  choices.until(number, [](std::uint64_t n) { return n % 1000 == 999; });
  throw Refuted("it is rare");
}

/// Once: whoever asks twice wants the program to end at once.
void interrupts(Draw& choices) {
  static std::atomic_flag done = ATOMIC_FLAG_INIT;
  if (!done.test_and_set()) interrupt_who_checks();
  holds(choices);
}

/// Fails at once, and aborts a few inputs later.
void fails_then_aborts(Draw&) {
  static std::atomic<int> done = 0;
  if (++done > 50) std::abort();
  throw Refuted("before it aborts");
}

/// As a property with a race or stale state does.
void fails_once(Draw& choices) {
  static std::atomic_flag done = ATOMIC_FLAG_INIT;
  if (!done.test_and_set()) throw Refuted("the first time");
  holds(choices);
}

/// The simplest input is hundreds of runs away, and aborts.
void takes_long_to_shrink(Draw& choices, int runs) {
  static std::atomic<int> done = 0;
  if (++done > runs) std::abort();
  int large = 0;
  for (int i = 0; i < 100; ++i) large += choices.choose(std::uint64_t{1} << 60) > 100 ? 1 : 0;
  if (large >= 20) throw Refuted("many are large");
}

void interrupts_when_shrunk(Draw& choices) {
  static std::atomic<int> done = 0;
  if (++done == 20) interrupt_who_checks();
  takes_long_to_shrink(choices, 100);
}

void is_slow(Draw& choices) {
  std::this_thread::sleep_for(std::chrono::milliseconds(5));
  takes_long_to_shrink(choices, 200);
}

std::vector<Property> misbehaving() {
  return {{"made_up.holds", "", "", holds},
          {"made_up.fails_on_empty", "", "", fails_on_empty},
          {"made_up.fails_on_all", "", "", fails_on_all},
          {"made_up.is_discarded", "", "", is_discarded},
          {"made_up.segfaults", "", "", segfaults},
          {"made_up.aborts", "", "", aborts},
          {"made_up.overflows_the_stack", "", "", overflows_the_stack},
          {"made_up.aborts_when_shrunk", "", "", aborts_when_shrunk},
          {"made_up.fails_then_aborts", "", "", fails_then_aborts},
          {"made_up.fails_once", "", "", fails_once},
          {"made_up.interrupts_when_shrunk", "", "", interrupts_when_shrunk},
          {"made_up.is_slow", "", "", is_slow},
          {"made_up.interrupts", "", "", interrupts},
          {"made_up.wants_memory", "", "", wants_memory},
          {"made_up.hangs", "", "", hangs},
          {"made_up.draws_without_end", "", "", draws_without_end},
          {"made_up.refuses_all_draws", "", "", refuses_all_draws},
          {"made_up.fails_on_what_is_rare", "", "", fails_on_what_is_rare},
          {"made_up.interrupts_and_hangs", "", "", interrupts_and_hangs}};
}

}  // namespace
}  // namespace ccdfuzz

int main(int argc, char** argv) {
  ::setenv("MISBEHAVING_PROPERTIES", std::to_string(::getpid()).c_str(), 0);
  ccdfuzz::serve_if_asked(argc, argv, {.claims = ccdfuzz::misbehaving()});
  const auto suite = [](std::string_view name) -> ccdfuzz::Result<ccdfuzz::Suite> {
    return ccdfuzz::Suite{std::string(name), false, ccdfuzz::misbehaving()};
  };
  ccdfuzz::CommandLine line(ccdfuzz::misbehaving(), suite);
  ccdfuzz::add_check(line);
  ccdfuzz::add_triage(line);
  return line.parse_and_run(argc, argv);
}
