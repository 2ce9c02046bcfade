#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace ccdfuzz {

/// One line as people may see it: control characters, which a terminal would obey, as \u00xx or \n.
std::string shown_line(std::string_view text);
/// The same of text in which newlines end lines.
std::string shown_lines(std::string_view text);

/// What stands between the commas of a text; one empty text of an empty one.
std::vector<std::string> texts_between_commas(const std::string& text);

/// The text as one word of a shell's command line.
std::string shell_word(const std::string& text);

}  // namespace ccdfuzz
