#pragma once

#include <string>

#include "case/case.hpp"
#include "properties/property.hpp"

namespace ccdfuzz {

/// Reading any text gives an error that says something, or a case; what was read is written as a
/// text that reads as the same case, and then as the same text, in both layouts.
Check reader_takes_any_text(const std::string& text);

/// Writing a valid case and reading it gives the case back.
Check case_round_trip(const Case& value);

/// The text with a few changes of the kind that confuses readers, or none.
std::string draw_spoilt_text(Draw& choices, std::string text);

Check check_reader_on_bytes(Draw& choices);
Check check_reader_on_mutants(Draw& choices);
Check check_case_round_trip(Draw& choices);

}  // namespace ccdfuzz
