#pragma once

#include <array>
#include <string>
#include <string_view>

#include "base/enum_names.hpp"
#include "files/case_files.hpp"

namespace ccdfuzz {

enum class TestFramework : std::uint8_t { kGoogleTest, kCatch2 };
constexpr std::array<std::string_view, 2> names_of(TestFramework) {
  return {"gtest", "catch2"};
}

/// How a C++17 source file of tests begins, that needs ccdfuzz_plugin.h, the framework, and the
/// plug-in to link with.
std::string test_preamble(TestFramework framework);

/// A test in it of a case, the number-th from 1 on. It asks the plug-in the very query, with every
/// number as a hex float. It checks that the answer is one. A hit must be no later than the proven
/// contact. No hit may come where nothing touches in [0, t_max]. Requires a valid, checked
/// case. Errors, naming case and field: a trim, faces, a turn or a spin has no place in these
/// tests.
Result<std::string> test_snippet(const NamedCase& named, size_t number, TestFramework framework);

}  // namespace ccdfuzz
