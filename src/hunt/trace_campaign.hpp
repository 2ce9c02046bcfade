#pragma once

#include <atomic>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "ccd/witness_trace/trace.hpp"
#include "method/method.hpp"
#include "query/case.hpp"
#include "query/taxonomy.hpp"

namespace ccdfuzz {

struct TraceCampaignOptions {
  std::vector<std::string> methods;  ///< specs that parse_method_list accepted
  std::uint64_t seed = 0;
  std::uint64_t first = 0;  ///< number of the first case (traced_cases.hpp)
  std::uint64_t count = 0;  ///< how many cases; first + count ≤ 2^64
  TraceOptions trace;
  int threads = 1;
};

/// What one method did on the cases of one contact class.
struct TraceCell {
  ContactClass contact = ContactClass::kFF;
  std::string method;
  std::uint64_t traced = 0;
  std::uint64_t lost = 0;
  std::optional<std::uint64_t> margin;  ///< the smallest, of all that were kept
  std::optional<double> slack;          ///< the smallest, of all
  double cpu_seconds = 0;               ///< of tracing alone
};

/// A witness that was lost.
struct LostWitness {
  std::uint64_t number = 0;
  std::string method;
  bool breaks_claim = false;  ///< the method claims to have no false negative
  Trace trace;
  Case value;
};

struct TraceReport {
  std::vector<TraceCell> cells;  ///< class by class, in it method by method
  std::uint64_t cases = 0;
  std::uint64_t lost = 0, broken_claims = 0;
};

/// Traces the witnesses of generated cases. on_lost is called for each that is lost, in the order
/// of the numbers; on_cases with how many cases are done. Ends early, with what was traced until
/// then, once stop is true. The result depends neither on threads nor on the clock, cpu_seconds
/// apart.
TraceReport trace_generated(const TraceCampaignOptions& options,
                            const std::function<void(const LostWitness&)>& on_lost,
                            const std::function<void(std::uint64_t)>& on_cases,
                            const std::atomic<bool>& stop);

}  // namespace ccdfuzz
