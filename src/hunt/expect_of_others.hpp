#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "method/ask.hpp"

namespace ccdfuzz {

/// Of one search: what TDIBM needs on most finds.
inline constexpr std::uint64_t kEnoughPops = 2000;

/// Asks the methods that a find says nothing of yet, each with kEnoughPops at most, so that one
/// slow method does not take minutes, and has it expect what they do. Calls decided for each; what
/// is undecided is left out, since a larger budget may decide it. trees: as check_case.
void expect_of_others(
    Case& find, const std::vector<std::string>& methods, MethodSet& asked, SearchOptions search,
    const std::string& trees,
    const std::function<void(const std::string&, const Judged&)>& decided = nullptr);

}  // namespace ccdfuzz
