#pragma once

#include <mutex>
#include <optional>
#include <utility>

#include "eval/evaluate.hpp"
#include "files/check_file.hpp"

namespace ccdfuzz {

/// A case that several threads look at; the first of them decides and checks it.
class SharedCase {
 public:
  explicit SharedCase(NamedCase named) : named_(std::move(named)) {}

  const NamedCase& named() const { return named_; }

  /// As check_case, after decide_rows.
  const Result<CheckedCase>& checked() {
    std::call_once(once_, [this] {
      decide_rows(named_);
      checked_ = check_case(named_);
    });
    return *checked_;
  }

 private:
  NamedCase named_;
  std::once_flag once_;
  std::optional<Result<CheckedCase>> checked_;
};

}  // namespace ccdfuzz
