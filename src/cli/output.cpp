#include "cli/output.hpp"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "base/text.hpp"
#include "io/output_file.hpp"

namespace ccdfuzz {

namespace {

int first_errno = 0;
bool stdout_has_cases = false;

/// Standard output is a terminal, NO_COLOR is unset or empty, and TERM is not "dumb".
bool wants_colour() {
  const char *const term = std::getenv("TERM"), *const refused = std::getenv("NO_COLOR");
  return ::isatty(STDOUT_FILENO) == 1 && !(refused && *refused) &&
         !(term && std::string_view(term) == "dumb");
}

void write_out(const std::string& text) {
  if (stdout_has_cases) {
    std::fwrite(text.data(), 1, text.size(), stderr);
    return;
  }
  errno = 0;
  if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size() && first_errno == 0) {
    first_errno = errno;
  }
}

constexpr std::chrono::steady_clock::duration kRedrawPause = std::chrono::milliseconds(100),
                                              kFirstPause = std::chrono::seconds(20),
                                              kLongestPause = std::chrono::minutes(10);

size_t terminal_width() {
  winsize size{};
  const bool known = ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0;
  return known ? size.ws_col : 80;
}

/// "1:02:03", "2:03".
std::string clock_text(double seconds) {
  const auto s = static_cast<std::uint64_t>(std::ceil(seconds));
  return s < 3600 ? fmt::format("{}:{:02}", s / 60, s % 60)
                  : fmt::format("{}:{:02}:{:02}", s / 3600, s / 60 % 60, s % 60);
}

/// Extrapolates the progress since `before`; nothing before there is enough of it.
std::string time_left_text(double share, double before, double elapsed) {
  constexpr double kEnough = 0.5, kTooLong = 100 * 3600;  // seconds
  if (elapsed < kEnough || !(share > before) || share >= 1) return "";
  const double left = elapsed * (1 - share) / (share - before);
  return left > kTooLong ? "" : clock_text(left) + " left  ";
}

std::string rate_text(std::uint64_t done, std::string_view unit, double elapsed) {
  if (done == 0 || !(elapsed > 0)) return "";
  const double rate = static_cast<double>(done) / elapsed;
  return fmt::format("{:.{}f} {}/s  ", rate, rate < 10 ? 1 : 0, unit);
}

}  // namespace

void leave_stdout_to(const std::string& path) {
  stdout_has_cases = is_standard_output(path);
}

void print_out(const std::string& text) {
  write_out(shown_lines(text));
}

void print_table(const Table& table) {
  write_out(table.to_text(wants_colour()));
}

void print_rows(Table& table, size_t least) {
  write_out(table.take_text(wants_colour(), least));
}

void print_err(const std::string& text) {
  const std::string shown = shown_lines(text);
  std::fwrite(shown.data(), 1, shown.size(), stderr);
}

Result<void> flush_stdout() {
  errno = 0;
  if (std::fflush(stdout) != 0 && first_errno == 0) first_errno = errno;
  if (first_errno == 0 && std::ferror(stdout) == 0) return {};
  return input_error("stdout", "cannot write: {}",
                     std::strerror(first_errno == 0 ? EIO : first_errno));
}

Progress::Progress()
    : on_terminal_(isatty(STDERR_FILENO) == 1),
      next_(on_terminal_ ? start_ : start_ + kFirstPause) {}

void Progress::show(double share, const std::string& note, std::uint64_t done,
                    std::string_view unit) {
  const std::lock_guard lock(mutex_);
  const auto now = std::chrono::steady_clock::now();
  if (now < next_) return;
  next_ = now + (on_terminal_ ? kRedrawPause : std::min(kLongestPause, now - start_));
  constexpr size_t kBarWidth = 30;
  const auto filled =
      static_cast<size_t>(std::clamp(share, 0.0, 1.0) * static_cast<double>(kBarWidth));
  if (!first_) first_ = {share, now};
  const auto seconds_since = [now](auto then) {
    return std::chrono::duration<double>(now - then).count();
  };
  const std::string state =
      fmt::format("{:3.0f} %  {}{}{}", 100 * share,
                  time_left_text(share, first_->share, seconds_since(first_->at)),
                  rate_text(done, unit, seconds_since(start_)), shown_line(note));
  if (!on_terminal_) {
    std::fputs(fmt::format("ccdfuzz: {}\n", state).c_str(), stderr);
    return;
  }
  std::string line = fmt::format("[{}{}] {}", std::string(filled, '#'),
                                 std::string(kBarWidth - filled, '.'), state);
  // One column is left free: a terminal wraps when the last one is written.
  if (const size_t room = terminal_width() - 1; line.size() > room) line.resize(room);
  line.insert(0, "\r\x1b[K");
  std::fwrite(line.data(), 1, line.size(), stderr);
  std::fflush(stderr);
  drawn_ = true;
}

void Progress::clear() {
  const std::lock_guard lock(mutex_);
  if (!drawn_) return;
  std::fputs("\r\x1b[K", stderr);
  std::fflush(stderr);
  drawn_ = false;
}

}  // namespace ccdfuzz
