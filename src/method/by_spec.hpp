#pragma once

#include <functional>
#include <map>
#include <memory>
#include <string>

#include "base/verify.hpp"
#include "method/method.hpp"

namespace ccdfuzz {

/// One object for each spec, made when first asked for, by make unless by another; for one thread.
template <class T, Result<std::unique_ptr<T>> (*make)(const std::string& spec)>
class BySpec {
 public:
  using Make = std::function<Result<std::unique_ptr<T>>(const std::string& spec)>;
  BySpec() = default;
  explicit BySpec(Make other) : make_(std::move(other)) {}

  /// Null where there is none for this spec: a plug-in has no tracer.
  T* find(const std::string& spec) {
    std::unique_ptr<T>& one = made_[spec];
    if (!one) {
      if (Result<std::unique_ptr<T>> made = make_(spec)) one = std::move(*made);
    }
    return one.get();
  }

  /// Requires a spec that make accepts: of methods, one that parse_method_list accepted.
  T& operator[](const std::string& spec) {
    T* const one = find(spec);
    CCDFUZZ_VERIFY(one != nullptr);
    return *one;
  }

 private:
  Make make_ = make;
  std::map<std::string, std::unique_ptr<T>> made_;
};

using MethodSet = BySpec<Method, make_method>;
using TracerSet = BySpec<Tracer, make_tracer>;

}  // namespace ccdfuzz
