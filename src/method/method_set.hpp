#pragma once

#include <functional>
#include <map>
#include <memory>
#include <string>

#include "method/method.hpp"

namespace ccdfuzz {

/// One method for each spec, made when first asked for; for one thread.
class MethodSet {
 public:
  using Make = std::function<Result<std::unique_ptr<Method>>(const std::string& spec)>;
  MethodSet() = default;
  explicit MethodSet(Make make) : make_(std::move(make)) {}

  /// Requires a spec that make accepts: for make_method, one that parse_method accepted.
  Method& operator[](const std::string& spec) {
    std::unique_ptr<Method>& one = made_[spec];
    if (!one) one = value_or_throw(make_(spec));
    return *one;
  }

 private:
  Make make_ = make_method;
  std::map<std::string, std::unique_ptr<Method>> made_;
};

}  // namespace ccdfuzz
