#pragma once

#include <string>

namespace ccdfuzz {

/// The text as one word of a shell's command line.
std::string shell_word(const std::string& text);

}  // namespace ccdfuzz
