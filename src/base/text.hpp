#pragma once

#include <string>
#include <string_view>

namespace ccdfuzz {

/// One line as people may see it: control characters, which a terminal would obey, as \u00xx or \n.
std::string shown_line(std::string_view text);
/// The same of text in which newlines end lines.
std::string shown_lines(std::string_view text);

/// The text as one word of a shell's command line.
std::string shell_word(const std::string& text);

}  // namespace ccdfuzz
