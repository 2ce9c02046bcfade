#pragma once

#include <functional>
#include <string>
#include <vector>

#include "eval/ask.hpp"

namespace ccdfuzz {

/// Asks the methods that a find says nothing of yet, each with few pops, so that one slow method
/// does not take minutes, and has it expect what they do. Calls decided for each; what is undecided
/// is left out, since a larger budget may decide it.
void expect_of_others(
    Case& find, const std::vector<std::string>& methods, MethodSet& asked, SearchOptions search,
    const std::function<void(const std::string&, const Judged&)>& decided = nullptr);

}  // namespace ccdfuzz
