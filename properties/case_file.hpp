#pragma once

#include <string>

#include "properties/property.hpp"

namespace ccdfuzz {

/// Reading any text gives an error that says something, or a case; what was read is written as a
/// text that reads as the same case, and then as the same text, in both layouts.
void claim_reader_takes(const std::string& text);

/// The text with a few changes of the kind that confuses readers, or none.
std::string draw_spoilt_text(Draw& choices, std::string text);

}  // namespace ccdfuzz
