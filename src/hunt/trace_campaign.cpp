#include "hunt/trace_campaign.hpp"

#include <tbb/enumerable_thread_specific.h>

#include "eval/by_spec.hpp"
#include "eval/cpu_time.hpp"
#include "eval/in_order.hpp"
#include "hunt/scheduler.hpp"
#include "hunt/traced_cases.hpp"
#include "numeric/verify.hpp"

namespace ccdfuzz {

namespace {

/// What came of one block.
struct Traced {
  std::vector<TraceCell> cells;  ///< one a method
  std::vector<LostWitness> lost;
  std::uint64_t cases = 0;
};

template <class T>
void keep_least(std::optional<T>& least, const std::optional<T>& x) {
  if (x && (!least || *x < *least)) least = x;
}

void count(const Trace& trace, TraceCell& cell) {
  ++cell.traced;
  if (trace.lost) {
    ++cell.lost;
  } else if (trace.margin) {
    keep_least(cell.margin, std::optional(trace.margin->ulps));
  }
  if (trace.slack) keep_least(cell.slack, std::optional(trace.slack->value));
}

void add(const TraceCell& part, TraceCell& whole) {
  whole.traced += part.traced;
  whole.lost += part.lost;
  keep_least(whole.margin, part.margin);
  keep_least(whole.slack, part.slack);
  whole.cpu_seconds += part.cpu_seconds;
}

Traced trace_block(const TraceCampaignOptions& options, std::uint64_t block, TracerSet& tracers) {
  const TracedBlock made = traced_block(options.seed, block);
  const std::uint64_t start = block * kTracedBlock;
  Traced out;
  for (const std::string& method : options.methods) {
    TraceCell& cell = out.cells.emplace_back();
    cell.contact = made.contact;
    cell.method = method;
  }
  for (std::uint64_t i = 0; i < made.cases.size(); ++i) {
    if (start + i < options.first || start + i - options.first >= options.count) continue;
    const Case& known = made.cases[i];
    ++out.cases;
    for (TraceCell& cell : out.cells) {
      const double before = thread_cpu_seconds();
      const Trace& trace =
          tracers[cell.method].trace(known.query, *known.truth.witness, options.trace);
      cell.cpu_seconds += thread_cpu_seconds() - before;
      count(trace, cell);
      if (!trace.lost) continue;
      const bool claims = method_info(cell.method)->claims_no_false_negative;
      out.lost.push_back({start + i, cell.method, claims, trace, known});
    }
  }
  return out;
}

}  // namespace

TraceReport trace_generated(const TraceCampaignOptions& options,
                            const std::function<void(const LostWitness&)>& on_lost,
                            const std::function<void(std::uint64_t)>& on_cases,
                            const std::atomic<bool>& stop) {
  CCDFUZZ_VERIFY(!options.methods.empty() && options.count >= 1 && options.threads >= 1);
  TraceReport report;
  for (const ContactClass contact : kContactClasses) {
    for (const std::string& method : options.methods) {
      TraceCell& cell = report.cells.emplace_back();
      cell.contact = contact;
      cell.method = method;
    }
  }
  const std::uint64_t first_block = options.first / kTracedBlock;
  const std::uint64_t last_block = (options.first + (options.count - 1)) / kTracedBlock;
  tbb::enumerable_thread_specific<TracerSet> tracers;
  run_in_order<Traced>(
      last_block - first_block + 1, options.threads,
      [&](size_t i) { return trace_block(options, first_block + i, tracers.local()); },
      [&](const Traced& traced) {
        const size_t row = static_cast<size_t>(traced.cells.front().contact);
        for (size_t m = 0; m < traced.cells.size(); ++m) {
          add(traced.cells[m], report.cells[row * options.methods.size() + m]);
        }
        report.cases += traced.cases;
        for (const LostWitness& lost : traced.lost) {
          ++report.lost;
          report.broken_claims += lost.breaks_claim ? 1 : 0;
          on_lost(lost);
        }
        on_cases(report.cases);
      },
      &stop);
  return report;
}

}  // namespace ccdfuzz
