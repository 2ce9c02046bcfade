#pragma once

#include <string_view>

namespace ccdfuzz {

/// The name of the suite whose claims this program checks (suite.cpp). What links this mutates and
/// crosses choices (generators/draw/mutate_choices.hpp), and draws every other input anew; but not
/// texts.
extern const std::string_view kSuite;

}  // namespace ccdfuzz
