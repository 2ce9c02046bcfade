#pragma once

#include "method/method.hpp"

namespace ccdfuzz {

/// The method of a spec that a user gave.
inline Result<std::unique_ptr<Method>> admitted(const std::string& spec) {
  return admit_plugin(spec).and_then([&] { return make_method(spec); });
}

}  // namespace ccdfuzz
