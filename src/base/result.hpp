#pragma once

#include <stdexcept>
#include <string>
#include <tl/expected.hpp>

namespace ccdfuzz {

/// Why outside data was refused: where it is and what is wrong with it.
struct InputError {
  std::string where;  ///< file and JSON path, or option name; may be empty
  std::string what;   ///< the complaint, with the offending value
  /// Nothing is known to be wrong with it: looking on would have taken too long.
  bool is_limit = false;

  std::string message() const { return where.empty() ? what : where + ": " + what; }
};

/// A value, or the reason why outside data does not give one.
template <class T>
using Result = tl::expected<T, InputError>;

inline tl::unexpected<InputError> input_error(std::string where, std::string what) {
  return tl::unexpected<InputError>({std::move(where), std::move(what)});
}

/// The value of the result, where no caller can take an error. Throws the error's message.
template <class T>
T value_or_throw(Result<T> result) {
  if (!result) throw std::runtime_error(result.error().message());
  return *std::move(result);
}

}  // namespace ccdfuzz
