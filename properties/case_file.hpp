#pragma once

#include <string>

#include "properties/property.hpp"

namespace ccdfuzz {

/// Reading any text gives a case, or an error that says something. A case is written as a text that
/// reads as the same case, and again as the same text, in both layouts.
void claim_reader_takes(const std::string& text);

/// The text with a few changes of the kind that confuses readers, or none.
std::string draw_spoilt_text(Draw& choices, std::string text);

}  // namespace ccdfuzz
