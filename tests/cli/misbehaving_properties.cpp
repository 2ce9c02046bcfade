// `ccdfuzz check` and `ccdfuzz triage` of made-up properties, each of which misbehaves as its name
// says.
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <iostream>
#include <string>
#include <thread>

#include "cli/command.hpp"
#include "hunt/serve.hpp"
#include "properties/suites.hpp"

namespace ccdfuzz {
namespace {

Check holds(Draw& choices) {
  choices.choose(9);
  return Check::holds();
}

/// True of every input with a byte of text; the counterexample is the empty one.
Check fails_on_empty(Draw& choices) {
  return choices.text(8).empty() ? Check::fails("the text is empty") : Check::holds();
}

/// Shrinks to the byte 0.
Check fails_on_all(Draw& choices) {
  return Check::fails("drew " + std::to_string(choices.choose(1) == 0 ? 0 : 1));
}

Check is_discarded(Draw& choices) {
  choices.choose(9);
  return Check::discarded("");
}

bool one_in_a_hundred(Draw& choices) {
  return choices.choose(std::uint64_t{1} << 40) % 100 == 99;
}

Check segfaults(Draw& choices) {
  if (one_in_a_hundred(choices)) std::raise(SIGSEGV);
  return Check::holds();
}

Check aborts(Draw& choices) {
  if (one_in_a_hundred(choices)) std::abort();
  return Check::holds();
}

/// More than any process is given.
Check wants_memory(Draw& choices) {
  std::vector<std::string> all;
  while (one_in_a_hundred(choices)) all.emplace_back(std::size_t{1} << 40, 'x');
  return Check::holds();
}

/// Deeper than any stack; the sum keeps the calls from becoming a loop.
int depth(volatile int* below) {
  volatile int here[64] = {*below + 1};
  return here[0] == 1'000'000'000 ? 0 : depth(here) + here[0];
}

Check overflows_the_stack(Draw& choices) {
  volatile int none = 0;
  if (one_in_a_hundred(choices)) none = depth(&none);
  return Check::holds();
}

/// Fails on large numbers, and aborts on what they are shrunk to.
Check aborts_when_shrunk(Draw& choices) {
  const std::uint64_t number = choices.choose(std::uint64_t{1} << 40);
  if (number > 1000) return Check::fails("a large number");
  if (number > 500) std::abort();
  return Check::holds();
}

/// Whoever checks, not the child that this runs in.
void interrupt_who_checks() {
  ::kill(std::atoi(std::getenv("MISBEHAVING_PROPERTIES")), SIGINT);
}

Check interrupts_and_hangs(Draw&) {
  interrupt_who_checks();
  for (;;) std::this_thread::sleep_for(std::chrono::seconds(1000));
}

Check hangs(Draw& choices) {
  if (!one_in_a_hundred(choices)) return Check::holds();
  std::cout << "hanging" << std::endl;  // NOLINT: whoever waits for it must see it
  for (;;) std::this_thread::sleep_for(std::chrono::seconds(1000));
}

/// Once: whoever asks twice wants the program to end at once.
Check interrupts(Draw& choices) {
  static std::atomic_flag done = ATOMIC_FLAG_INIT;
  if (!done.test_and_set()) interrupt_who_checks();
  return holds(choices);
}

/// Fails at once, and aborts a few inputs later.
Check fails_then_aborts(Draw&) {
  static std::atomic<int> done = 0;
  if (++done > 50) std::abort();
  return Check::fails("before it aborts");
}

/// As a property with a race or stale state does.
Check fails_once(Draw& choices) {
  static std::atomic_flag done = ATOMIC_FLAG_INIT;
  return done.test_and_set() ? holds(choices) : Check::fails("the first time");
}

/// The simplest input is hundreds of runs away, and aborts where it comes to that.
Check takes_long_to_shrink(Draw& choices, int runs) {
  static std::atomic<int> done = 0;
  if (++done > runs) std::abort();
  int large = 0;
  for (int i = 0; i < 100; ++i) large += choices.choose(1000) > 100 ? 1 : 0;
  return large < 20 ? Check::holds() : Check::fails("many are large");
}

Check interrupts_when_shrunk(Draw& choices) {
  static std::atomic<int> done = 0;
  if (++done == 20) interrupt_who_checks();
  return takes_long_to_shrink(choices, 100);
}

Check is_slow(Draw& choices) {
  std::this_thread::sleep_for(std::chrono::milliseconds(5));
  return takes_long_to_shrink(choices, 200);
}

std::vector<Property> misbehaving() {
  constexpr auto kHolds = Expectation::kHolds;
  return {{"made_up.holds", "", "", kHolds, holds},
          {"made_up.fails_on_empty", "", "", kHolds, fails_on_empty},
          {"made_up.fails_on_all", "", "", kHolds, fails_on_all},
          {"made_up.is_discarded", "", "", kHolds, is_discarded},
          {"made_up.segfaults", "", "", kHolds, segfaults},
          {"made_up.aborts", "", "", kHolds, aborts},
          {"made_up.overflows_the_stack", "", "", kHolds, overflows_the_stack},
          {"made_up.aborts_when_shrunk", "", "", kHolds, aborts_when_shrunk},
          {"made_up.fails_then_aborts", "", "", kHolds, fails_then_aborts},
          {"made_up.fails_once", "", "", kHolds, fails_once},
          {"made_up.interrupts_when_shrunk", "", "", kHolds, interrupts_when_shrunk},
          {"made_up.is_slow", "", "", kHolds, is_slow},
          {"made_up.interrupts", "", "", kHolds, interrupts},
          {"made_up.wants_memory", "", "", kHolds, wants_memory},
          {"made_up.hangs", "", "", kHolds, hangs},
          {"made_up.interrupts_and_hangs", "", "", kHolds, interrupts_and_hangs}};
}

}  // namespace
}  // namespace ccdfuzz

int main(int argc, char** argv) {
  ::setenv("MISBEHAVING_PROPERTIES", std::to_string(::getpid()).c_str(), 0);
  ccdfuzz::serve_if_asked(argc, argv, {.claims = ccdfuzz::misbehaving()});
  ccdfuzz::CommandLine line;
  ccdfuzz::add_check(line, ccdfuzz::misbehaving());
  ccdfuzz::add_triage(line, [](std::string_view name) -> ccdfuzz::Result<ccdfuzz::Suite> {
    return ccdfuzz::Suite{std::string(name), false, ccdfuzz::misbehaving()};
  });
  return line.parse_and_run(argc, argv);
}
