#pragma once

#include <map>
#include <memory>
#include <string>

#include "method/method.hpp"

namespace ccdfuzz {

/// One tracer for each spec, made when first asked for; for one thread.
class TracerSet {
 public:
  /// Requires a spec that parse_method_list accepted.
  Tracer& operator[](const std::string& spec);

 private:
  std::map<std::string, std::unique_ptr<Tracer>> tracers_;
};

}  // namespace ccdfuzz
