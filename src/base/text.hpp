#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace ccdfuzz {

/// One line as people may see it: control characters, which a terminal would obey, as \u00xx or \n.
/// A byte that is of no UTF-8 character is \xNN.
std::string shown_line(std::string_view text);
/// The same of text in which newlines end lines.
std::string shown_lines(std::string_view text);

/// The columns of a terminal that everybody has.
inline constexpr std::size_t kTextWidth = 80;
/// Whether a byte of UTF-8 is none that a character begins with.
inline bool continues_character(char c) {
  return (static_cast<unsigned char>(c) & 0xc0U) == 0x80U;
}
/// Code points of UTF-8 text.
std::size_t width(std::string_view text);
/// The text in lines of at most kTextWidth columns, broken at blanks alone. Lines after the first
/// begin with `indent` blanks; `column` is where the first one begins. No newline ends it.
std::string wrapped(std::string_view text, std::size_t indent, std::size_t column = 0);

/// "; did you mean X?", where X is the nearest of the known words. At most a letter and a quarter
/// of its letters are put in, left out or changed. Empty if none is so near.
std::string did_you_mean(std::string_view word, const std::vector<std::string>& known);

/// The parts of a text between its commas, or other marks; for an empty text one empty part.
std::vector<std::string> texts_between(const std::string& text, char mark = ',');

/// ", 0.031 deep, 310 times the tolerance" in space, where that is above 0 and no larger than the
/// size; empty for a size of 0. Rounded down, but for errors of doubles: a size is proven at least.
std::string beside_tolerance(double size, const char* what, double tolerance);

/// The text as one word of a shell's command line.
std::string shell_word(const std::string& text);

}  // namespace ccdfuzz
