#pragma once

#include <fmt/core.h>

#include <stdexcept>
#include <string>
#include <tl/expected.hpp>
#include <utility>

namespace ccdfuzz {

/// Why outside data was refused: where it is and what is wrong with it.
struct InputError {
  std::string where;  ///< file and JSON path, or option name; may be empty
  std::string what;   ///< the complaint, with the offending value
  /// Nothing is known to be wrong with it: it could not be read, or looking on would have taken too
  /// long.
  bool is_limit = false;

  std::string message() const { return where.empty() ? what : where + ": " + what; }
};

/// A value, or the reason why outside data does not give one.
template <class T>
using Result = tl::expected<T, InputError>;

inline tl::unexpected<InputError> input_error(std::string where, std::string what) {
  return tl::unexpected<InputError>({std::move(where), std::move(what)});
}

/// The same, with what is filled in by fmt::format.
template <class... Values>
requires(sizeof...(Values) > 0) tl::unexpected<InputError> input_error(
    std::string where, fmt::format_string<Values...> what, Values&&... values) {
  return input_error(std::move(where), fmt::format(what, std::forward<Values>(values)...));
}

/// Declares a variable for what a Result holds, or assigns it to one; if it holds an error, returns
/// that from the function: CCDFUZZ_TRY(const auto line, lines.next());
#define CCDFUZZ_TRY(declaration, ...) \
  CCDFUZZ_TRY_AS(CCDFUZZ_RESULT_OF_LINE(__LINE__), declaration, __VA_ARGS__)
/// The same where what it holds is not needed.
#define CCDFUZZ_TRY_VOID(...)                           \
  if (auto result_to_try = __VA_ARGS__; !result_to_try) \
  return tl::unexpected(std::move(result_to_try).error())

#define CCDFUZZ_RESULT_OF_LINE(line) CCDFUZZ_RESULT_OF(line)
#define CCDFUZZ_RESULT_OF(line) result_of_line_##line
#define CCDFUZZ_TRY_AS(result, declaration, ...)                 \
  auto result = __VA_ARGS__;                                     \
  if (!result) return tl::unexpected(std::move(result).error()); \
  declaration = *std::move(result)

/// The value of the result, where no caller can take an error. Throws the error's message.
template <class T>
T value_or_throw(Result<T> result) {
  if (!result) throw std::runtime_error(result.error().message());
  return *std::move(result);
}

}  // namespace ccdfuzz
