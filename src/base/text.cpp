#include "base/text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstdlib>
#include <functional>
#include <numeric>
#include <optional>
#include <utility>

#include "base/double_parts.hpp"

namespace ccdfuzz {

namespace {

/// A character of UTF-8, and how many bytes it takes.
struct Decoded {
  std::uint32_t code_point;
  std::size_t bytes;
};

/// The first character of the text; nullopt if its first byte begins none. So it is where a form is
/// longer than needed, of a surrogate, or past U+10FFFF.
std::optional<Decoded> first_character(std::string_view text) {
  const auto lead = static_cast<unsigned char>(text[0]);
  if (lead < 0x80) return Decoded{lead, 1};
  const auto bytes = static_cast<std::size_t>(std::countl_one(lead));
  if (bytes < 2 || bytes > 4 || bytes > text.size()) return std::nullopt;
  std::uint32_t code_point = lead & (0xffU >> (bytes + 1));
  for (const char c : text.substr(1, bytes - 1)) {
    if (!continues_character(c)) return std::nullopt;
    code_point = code_point << 6 | (static_cast<unsigned char>(c) & 0x3fU);
  }
  constexpr std::array<std::uint32_t, 5> kLeast = {0, 0, 0x80, 0x800, 0x10000};
  const bool is_surrogate = 0xd800 <= code_point && code_point < 0xe000;
  if (code_point < kLeast[bytes] || is_surrogate || code_point > 0x10ffff) return std::nullopt;
  return Decoded{code_point, bytes};
}

std::string without_controls(std::string_view text, std::string_view newline) {
  std::string shown;
  while (!text.empty()) {
    const std::optional<Decoded> next = first_character(text);
    const std::size_t bytes = next ? next->bytes : 1;
    if (!next) {
      shown += fmt::format("\\x{:02x}", static_cast<unsigned char>(text[0]));
    } else if (next->code_point == '\n') {
      shown += newline;
    } else if (next->code_point < ' ' || (0x7f <= next->code_point && next->code_point < 0xa0)) {
      shown += fmt::format("\\u{:04x}", next->code_point);
    } else {
      shown += text.substr(0, bytes);
    }
    text.remove_prefix(bytes);
  }
  return shown;
}

}  // namespace

std::string shown_line(std::string_view text) {
  return without_controls(text, "\\n");
}

std::string shown_lines(std::string_view text) {
  return without_controls(text, "\n");
}

std::size_t width(std::string_view text) {
  return static_cast<std::size_t>(std::ranges::count_if(text, std::not_fn(continues_character)));
}

std::string wrapped(std::string_view text, std::size_t indent, std::size_t column) {
  std::string out;
  bool begins = true;  // the line has only blanks so far
  while (!text.empty()) {
    const std::size_t end = std::min(text.find_first_of(" \n"), text.size());
    const std::string_view word = text.substr(0, end);
    const std::size_t needed = width(word) + (begins ? 0 : 1);
    if (!begins && column + needed > kTextWidth) {
      out += "\n" + std::string(indent, ' ');
      column = indent;
    } else if (!begins) {
      out += ' ';
      ++column;
    }
    out += word;
    column += width(word);
    begins = false;
    if (end < text.size() && text[end] == '\n') {
      out += "\n" + std::string(indent, ' ');
      column = indent;
      begins = true;
    }
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return out;
}

std::string did_you_mean(std::string_view word, const std::vector<std::string>& known) {
  const std::string* nearest = nullptr;
  std::size_t least = 0;
  for (const std::string& other : known) {
    constexpr std::size_t kLongest = 100;
    if (word.size() > kLongest || other.size() > kLongest) continue;
    // row[j]: the changes that make the first j letters of `other` of those of `word` so far.
    std::vector<std::size_t> row(other.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t{0});
    for (std::size_t i = 0; i < word.size(); ++i) {
      std::size_t diagonal = std::exchange(row[0], i + 1);
      for (std::size_t j = 0; j < other.size(); ++j) {
        const std::size_t changed = diagonal + (word[i] == other[j] ? 0 : 1);
        diagonal = row[j + 1];
        row[j + 1] = std::min({changed, diagonal + 1, row[j] + 1});
      }
    }
    if (row.back() <= 1 + other.size() / 4 && (nearest == nullptr || row.back() < least)) {
      nearest = &other;
      least = row.back();
    }
  }
  return nearest == nullptr ? "" : fmt::format("; did you mean {}?", *nearest);
}

std::vector<std::string> texts_between(const std::string& text, char mark) {
  std::vector<std::string> texts;
  for (size_t begin = 0; begin <= text.size();) {
    const size_t end = std::min(text.find(mark, begin), text.size());
    texts.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return texts;
}

std::string beside_tolerance(double size, const char* what, double tolerance) {
  const auto rounded = [](double x) {
    constexpr size_t kTwoDigits = 3;                     // and the point
    const std::string text = fmt::format("{:.11e}", x);  // without what doubles are off by
    const std::string digits = text.substr(0, kTwoDigits) + text.substr(text.find('e'));
    return std::strtod(digits.c_str(), nullptr);
  };
  if (!(size > 0) || !is_finite(size)) return "";
  const std::string text = fmt::format(", {:g} {}", rounded(size), what);
  const double times = size / tolerance;
  if (!(tolerance > 0) || size < tolerance || !is_finite(times)) return text;
  return text + fmt::format(", {:g} times the tolerance", rounded(times));
}

std::string shell_word(const std::string& text) {
  constexpr const char* kPlain =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789/._-+:,=@%";
  if (!text.empty() && text.find_first_not_of(kPlain) == std::string::npos) return text;
  // What no terminal should get is spelled as bash and zsh have it.
  const bool is_shown = shown_line(text) == text;
  std::string quoted;
  for (const char c : text) {
    if (c == '\'') quoted += is_shown ? "'\\'" : "\\";
    if (c == '\\' && !is_shown) quoted += '\\';
    quoted += c;
  }
  return is_shown ? "'" + quoted + "'" : "$'" + shown_line(quoted) + "'";
}

}  // namespace ccdfuzz
