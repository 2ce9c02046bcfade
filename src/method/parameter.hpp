#pragma once

#include <optional>
#include <string>

#include "numeric/result.hpp"

namespace ccdfuzz {

/// A concrete method spec in two parts: "tdibm-h:1e-12" is {"tdibm-h", "1e-12"}. The argument is
/// what stands after the first ':', and may be empty; it is absent if there is no ':'.
struct SplitSpec {
  std::string name;
  std::optional<std::string> argument;
};

SplitSpec split_spec(const std::string& spec);

/// The pull-apart factor of tdibm-h and tdibm-h-rel: a finite number ≥ 0, decimal or hex-float,
/// with nothing before or after it. Errors: anything else, naming spec and value.
Result<double> parse_pull_apart(const std::string& spec);

}  // namespace ccdfuzz
