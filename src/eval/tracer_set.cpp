#include "eval/tracer_set.hpp"

#include "numeric/verify.hpp"

namespace ccdfuzz {

Tracer& TracerSet::operator[](const std::string& spec) {
  std::unique_ptr<Tracer>& tracer = tracers_[spec];
  if (!tracer) {
    Result<std::unique_ptr<Tracer>> made = make_tracer(spec);
    CCDFUZZ_VERIFY(made.has_value());
    tracer = std::move(*made);
  }
  return *tracer;
}

}  // namespace ccdfuzz
