#include "cli/terminal.hpp"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <string_view>

namespace ccdfuzz {

namespace {

bool set_and_not_empty(const char* variable) {
  const char* const value = std::getenv(variable);
  return value && *value;
}

size_t terminal_width() {
  winsize size{};
  const bool known = ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0;
  return known ? size.ws_col : 80;
}

}  // namespace

bool wants_colour(std::FILE* stream) {
  const char* const term = std::getenv("TERM");
  return isatty(fileno(stream)) == 1 && !set_and_not_empty("NO_COLOR") &&
         !(term && std::string_view(term) == "dumb");
}

Progress::Progress() : enabled_(isatty(STDERR_FILENO) == 1) {}

void Progress::show(double share, const std::string& note) {
  if (!enabled_) return;
  const std::lock_guard lock(mutex_);
  const auto now = std::chrono::steady_clock::now();
  if (now < next_) return;
  next_ = now + std::chrono::milliseconds(100);
  constexpr size_t kBarWidth = 30;
  const auto filled =
      static_cast<size_t>(std::clamp(share, 0.0, 1.0) * static_cast<double>(kBarWidth));
  std::string line = fmt::format("[{}{}] {:3.0f} %  {}", std::string(filled, '#'),
                                 std::string(kBarWidth - filled, '.'), 100 * share, note);
  // One column is left free: a terminal wraps when the last one is written.
  if (const size_t room = terminal_width() - 1; line.size() > room) line.resize(room);
  fmt::print(stderr, "\r\x1b[K{}", line);
  std::fflush(stderr);
  drawn_ = true;
}

void Progress::clear() {
  const std::lock_guard lock(mutex_);
  if (!drawn_) return;
  fmt::print(stderr, "\r\x1b[K");
  std::fflush(stderr);
  drawn_ = false;
}

}  // namespace ccdfuzz
