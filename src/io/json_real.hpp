#pragma once

#include "io/json_tree.hpp"

namespace ccdfuzz {

/// The longest text of a number that is read. The longest decimal that is exactly a double has
/// 1,077 characters.
inline constexpr size_t kMaxNumberLength = 2000;

/// The double that a JSON number's text or a hex float's text ("0x1.8p-3") means. Decimal
/// fractions round to nearest; integers and hex floats must be doubles exactly.
/// Errors: the reason, naming the text; `where` is left to the caller.
Result<double> parse_real(const JsonValue& value);

/// The same for files, which must say exactly what they mean. A decimal of at most 17 significant
/// digits names the double nearest to it, as 0.1 does; 17 tell all doubles apart. A longer one must
/// be a double exactly. Errors: as parse_real, and a longer one that is none, naming the nearest.
Result<double> parse_exact_real(const JsonValue& value);

}  // namespace ccdfuzz
