#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "fault_list.hpp"
#include "records.hpp"

namespace ccdfuzz {

/// A record as a line of JSON, without the line's end.
std::string to_line(const Record& record);

/// The record of a line. Errors name where, field and value. The line is no JSON, or a field is
/// missing, unknown or of another kind. The driver or the fault is unknown.
/// The seed or the limit is 0.
Result<Record> parse_record(std::string_view line, const std::string& where,
                            const std::vector<PlantedFault>& faults);

}  // namespace ccdfuzz
