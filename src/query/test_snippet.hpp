#pragma once

#include <string>
#include <vector>

#include "query/case_files.hpp"

namespace ccdfuzz {

enum class TestFramework : std::uint8_t { kGoogleTest, kCatch2 };

/// A C++17 source file with a test for each case, that needs ccdfuzz_plugin.h, the framework, and
/// the plug-in to link with. Each asks the plug-in the very query (every number a hex float) and
/// checks what the truth proves: a hit no later than the contact; no hit where nothing touches in
/// [0, t_max]; and in any case an answer that is one. Requires valid, checked cases.
std::string test_snippet(const std::vector<NamedCase>& cases, TestFramework framework);

}  // namespace ccdfuzz
