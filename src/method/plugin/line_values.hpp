#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <tl/expected.hpp>

#include "io/child.hpp"
#include "io/json_tree.hpp"

namespace ccdfuzz {

// The values of a line that a plug-in answers with, which may hold anything.

tl::unexpected<Fault> answer_fault(const std::string& name, const std::string& note);
/// It is no answer.
tl::unexpected<Fault> garbage_answer(const std::string& note);

/// The object that the line is; NaN and infinities may stand there bare. Errors: garbage.
tl::expected<JsonValue, Fault> parse_object(const std::string& line);

/// The text at the key; "" for none.
std::string text_of(const JsonValue& object, std::string_view key);
/// A number as a question has it: one that is not finite is "nan", "inf" or "-inf".
std::string any_number(double x);
/// False for null and for what is left out.
bool is_given(const JsonValue* value);
/// A number that need not be finite; absent for null, for nothing and for what is none.
std::optional<double> number_of(const JsonValue* value);
/// A whole number in [0, 2^63).
std::optional<std::uint64_t> whole_of(const JsonValue* value);

/// Reads a count that may be left out or null. Errors: garbage, for what is none.
tl::expected<void, Fault> read_count(const JsonValue& object, std::string_view key,
                                     std::uint64_t& out);
/// Reads what it may have measured: left out or null, NaN, or a number in [0, most]. Returns
/// whether there is one. Errors: garbage, for anything else.
tl::expected<bool, Fault> read_measure(const JsonValue& object, std::string_view key, double most,
                                       double& out);

}  // namespace ccdfuzz
