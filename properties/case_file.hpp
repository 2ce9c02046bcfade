#pragma once

#include <string>

#include "case/case.hpp"
#include "properties/property.hpp"

namespace ccdfuzz {

/// Reading any text gives a case, or an error that says something. A case is written as a text that
/// reads as the same case, and again as the same text, in both layouts.
void claim_reader_takes(const std::string& text);

/// All that a file may say of a query, true or not, of numbers that are drawn so.
using DrawRational = Rational(Draw& choices);
Truth draw_any_truth(Draw& choices, const Query& query, DrawRational* draw_number);

/// The text with a few changes of the kind that confuses readers, or none.
std::string draw_spoilt_text(Draw& choices, std::string text);

}  // namespace ccdfuzz
