#include "cli/crash_report.hpp"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <csignal>
#include <string_view>
#include <vector>

// Of AddressSanitizer's runtime, where it is linked.
extern "C" __attribute__((weak)) void __sanitizer_set_death_callback(void (*callback)());

namespace ccdfuzz {

namespace {

struct FatalSignal {
  int number;
  const char* name;
};
constexpr std::array kFatalSignals = {
    FatalSignal{SIGSEGV, "SIGSEGV"}, FatalSignal{SIGBUS, "SIGBUS"}, FatalSignal{SIGFPE, "SIGFPE"},
    FatalSignal{SIGILL, "SIGILL"}, FatalSignal{SIGABRT, "SIGABRT"}};

/// All that a handler reads. before: nullptr where the thread is at no site.
struct Site {
  const std::string* before = nullptr;
  std::uint64_t index = 0;
  const std::string* after = nullptr;
};
thread_local Site thread_site;

/// A text in memory of its own size: a handler may not allocate.
class Line {
 public:
  void add(std::string_view text) {
    const std::size_t size = std::min(text.size(), text_.size() - size_);
    std::copy_n(text.data(), size, text_.data() + size_);
    size_ += size;
  }
  void add(std::uint64_t number) {
    std::array<char, 20> digits{};
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), number).ptr;
    add(std::string_view(digits.data(), static_cast<std::size_t>(end - digits.data())));
  }
  void write() const {
    for (std::size_t done = 0; done < size_;) {
      const ssize_t more = ::write(STDERR_FILENO, text_.data() + done, size_ - done);
      if (more <= 0) return;
      done += static_cast<std::size_t>(more);
    }
  }

 private:
  std::array<char, 8192> text_;
  std::size_t size_ = 0;
};

void tell(std::string_view what) {
  if (thread_site.before == nullptr) return;
  Line line;
  line.add("ccdfuzz: ");
  line.add(what);
  line.add(*thread_site.before);
  line.add(thread_site.index);
  line.add(*thread_site.after);
  line.write();
}

void tell_sanitized() {
  tell("a sanitizer's report");
}

/// Tells, and has the signal again when it returns, with its default action.
void tell_and_die(int signal) {
  for (const FatalSignal& fatal : kFatalSignals) {
    if (fatal.number == signal) tell(fatal.name);
  }
  ::signal(signal, SIG_DFL);
  ::raise(signal);
}

bool arm() {
  for (const FatalSignal& fatal : kFatalSignals) {
    struct sigaction action {};
    ::sigaction(fatal.number, nullptr, &action);
    if ((action.sa_flags & SA_SIGINFO) != 0 || action.sa_handler != SIG_DFL) continue;
    action.sa_handler = tell_and_die;
    action.sa_flags = SA_ONSTACK;
    sigemptyset(&action.sa_mask);
    ::sigaction(fatal.number, &action, nullptr);
  }
  if (__sanitizer_set_death_callback != nullptr) __sanitizer_set_death_callback(tell_sanitized);
  return true;
}

/// Where a handler runs if the thread's own stack is used up, unless there is such a place already.
class HandlerStack {
 public:
  HandlerStack() {
    stack_t set{};
    ::sigaltstack(nullptr, &set);
    if ((set.ss_flags & SS_DISABLE) == 0) return;
    bytes_.resize(std::size_t{1} << 16);
    set = {};
    set.ss_sp = bytes_.data();
    set.ss_size = bytes_.size();
    ::sigaltstack(&set, nullptr);
  }
  ~HandlerStack() {
    if (bytes_.empty()) return;
    stack_t none{};
    none.ss_flags = SS_DISABLE;
    ::sigaltstack(&none, nullptr);
  }
  HandlerStack(const HandlerStack&) = delete;
  HandlerStack& operator=(const HandlerStack&) = delete;

 private:
  std::vector<char> bytes_;
};

}  // namespace

CrashSite::CrashSite(const std::string& before, std::uint64_t index, const std::string& after) {
  static const bool armed = arm();
  static_cast<void>(armed);
  thread_local const HandlerStack stack;
  thread_site = {&before, index, &after};
}

CrashSite::~CrashSite() {
  thread_site = {};
}

}  // namespace ccdfuzz
