#include "cli/output.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
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
  return input_error("stdout", fmt::format("cannot write: {}",
                                           std::strerror(first_errno == 0 ? EIO : first_errno)));
}

}  // namespace ccdfuzz
