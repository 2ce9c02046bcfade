// A plug-in that does what its option says, each of them something that no plug-in may do.
#include <sys/prctl.h>
#include <unistd.h>

#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <stdexcept>
#include <string>
#include <vector>

#include "ccdfuzz_plugin.h"

namespace {

struct State {
  std::string does;
  ccdfuzz_answer last{};
};

/// What it does when asked what it is, or else a query.
void misbehave(const std::string& does) {
  if (does == "crash") std::raise(SIGSEGV);
  if (does == "sleep") ::sleep(5);
  if (does == "abort") std::abort();
  if (does == "exit") std::exit(7);
  if (does == "throw") throw std::runtime_error("thrown by a plug-in");
  if (does == "hang") {
    while (true) ::pause();
  }
  if (does == "spin") {
    std::uint64_t volatile turns = 0;
    while (turns == 0) {
    }
  }
  if (does == "memory") {
    std::vector<std::vector<char>> all;
    while (true) all.emplace_back(std::size_t{1} << 24, 'x');
  }
  if (does == "malloc") {  // and then uses what it did not get
    while (true) {
      char volatile* const block = static_cast<char*>(std::malloc(std::size_t{1} << 24));
      for (std::size_t i = 0; i < std::size_t{1} << 24; i += 512) block[i] = 'x';
    }
  }
  if (does == "print") {
    while (true) std::puts("a plug-in that prints without end");
  }
}

/// Starts a process in a session of its own that would stay for ever. Returns its id.
pid_t leave_behind(const char* name = "left") {
  const pid_t left = ::fork();
  if (left != 0) return left;
  ::prctl(PR_SET_NAME, name);
  ::setsid();
  std::signal(SIGTERM, SIG_IGN);
  while (true) ::pause();
}

std::int32_t create(const char* options, void** state) {
  if (std::string(options) == "refuse") return 1;
  *state = new State{options};
  return 0;
}

void destroy(void* state) {
  delete static_cast<State*>(state);
}

std::int32_t describe(void* state, ccdfuzz_description* out) {
  const std::string& does = static_cast<State*>(state)->does;
  if (does.starts_with("describe-")) misbehave(does.substr(9));
  out->name = "misbehaving";
  out->claims = CCDFUZZ_CLOSED_T_MAX | CCDFUZZ_CONTACT_AT_ZERO | CCDFUZZ_CONSERVATIVE;
  if (does == "describe-size") out->size = 8;
  if (does == "old") out->size = offsetof(ccdfuzz_description, promise);
  if (does == "pairs") out->pair_count = std::uint64_t{1} << 40;
  return 0;
}

std::int32_t answer(void* state, const ccdfuzz_query* query, ccdfuzz_answer* out) {
  State& s = *static_cast<State*>(state);
  misbehave(s.does);
  if (s.does == "silent") return 0;
  if (s.does == "leave") out->iterations = static_cast<std::uint64_t>(leave_behind());
  if (s.does == "crowd") {
    for (int i = 0; i < 1000; ++i) out->iterations += leave_behind("ccdfuzz-crowd") > 0 ? 1U : 0U;
  }
  if (s.does == "leave-and-exit") {
    std::fprintf(stderr, "%d", static_cast<int>(leave_behind()));
    std::exit(7);
  }
  const ccdfuzz_answer before = s.last;
  out->verdict = CCDFUZZ_HIT;
  out->toi_lower = 0;
  if (s.does == "late") out->toi_lower = query->t_max;
  if (s.does == "nan") out->toi_lower = std::nan("");
  if (s.does == "half") out->uv[1][1] = 0.5;
  if (s.does == "no-toi") out->toi_lower = HUGE_VAL;
  if (s.does == "outside") out->toi_lower = query->t_max + 1;
  if (s.does == "negative") out->toi_lower = -1;
  if (s.does == "backwards") {
    out->toi_lower = query->t_max;
    out->toi_upper = -1;
  }
  if (s.does == "verdict") out->verdict = 99;
  if (s.does == "small") out->size = 4;
  if (s.does == "large") out->size = 1u << 30;
  if (s.does == "overrun") *reinterpret_cast<volatile char*>(out + 1) = 'x';
  if (s.does == "query") const_cast<double*>(query->patches[0]->positions[0])[0] += 1;
  if (s.does == "error") out->verdict = CCDFUZZ_ERROR;
  if (s.does == "status") return -1;
  if (s.does == "message") {
    for (char& c : out->message) c = '\xff';
  }
  if (s.does == "stale") {
    // What it would say now, it says the next time.
    out->toi_lower = query->t_max / 2;
    s.last = *out;
    if (before.verdict != 0) *out = before;
  }
  return 0;
}

}  // namespace

extern "C" const ccdfuzz_plugin* ccdfuzz_plugin_get(void) {
  static const ccdfuzz_plugin plugin = {
      sizeof(ccdfuzz_plugin), CCDFUZZ_PLUGIN_ABI, create, destroy, describe, answer};
  static const ccdfuzz_plugin lying = {12, CCDFUZZ_PLUGIN_ABI, create, destroy, describe, answer};
  // The environment: there is nothing else to ask before it is created.
  return std::getenv("CCDFUZZ_TEST_LYING_TABLE") != nullptr ? &lying : &plugin;
}
