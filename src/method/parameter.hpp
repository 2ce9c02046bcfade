#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.hpp"

namespace ccdfuzz {

/// A concrete method spec in two parts: "tdibm-h:1e-12" is {"tdibm-h", "1e-12"}. The argument is
/// what stands after the first ':', and may be empty; it is absent if there is no ':'.
struct SplitSpec {
  std::string name;
  std::optional<std::string> argument;
};

SplitSpec split_spec(const std::string& spec);

/// "tdibm-h:1e-12@absolute@unit-axes" in its parts: a spec, and how it is to be read.
struct SwitchedSpec {
  std::string spec;                   ///< "tdibm-h:1e-12"
  std::vector<std::string> switches;  ///< "absolute", "unit-axes"

  bool has(std::string_view name) const {
    return std::ranges::find(switches, name) != switches.end();
  }
};

/// What stands between '@'s behind the first; whether they are switches is for the caller to check.
SwitchedSpec split_switches(const std::string& spec);

/// The pull-apart factor of tdibm-h: a finite number ≥ 0, decimal or hex-float, with nothing before
/// or after it. Errors: anything else, naming spec and value.
Result<double> parse_pull_apart(const std::string& spec);

}  // namespace ccdfuzz
