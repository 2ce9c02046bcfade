#include <fmt/format.h>

#include "ccd/witness_trace/trace.hpp"
#include "cli/command.hpp"
#include "cli/common_options.hpp"
#include "cli/session.hpp"
#include "cli/shared_case.hpp"
#include "cli/trace_row.hpp"
#include "method/by_spec.hpp"

namespace ccdfuzz {

namespace {

struct TraceArguments {
  std::vector<std::string> files;
  std::vector<std::string> methods = default_methods();
  SearchFlags search;
  bool all = false;
};

/// How a case is traced. Throws BadInput: it has no witness within its step.
TraceOptions trace_options(const TraceArguments& options, const NamedCase& named) {
  const auto& witness = named.value.truth.witness;
  if (!witness) throw BadInput{{named.id + ": truth.witness", "is missing: nothing to trace"}};
  if (witness->t > exact(named.value.query.t_max)) {
    throw BadInput{{named.id + ": truth.witness.t",
                    fmt::format("{} is past t_max {}: nothing to trace", to_text(witness->t),
                                named.value.query.t_max)}};
  }
  return {options.search.options_for(named.value).precision, options.all};
}

int run_trace(const TraceArguments& options, Session& session) {
  for (const std::string& method : options.methods)
    need(make_tracer(method));  // no plug-in has one
  session.begin_table(trace_columns());
  tbb::enumerable_thread_specific<TracerSet> tracers;
  session.each_case<SharedCase, Trace>(
      options.files, options.methods.size(), "traces",
      [&](SharedCase& shared, size_t m) {
        need(shared.checked());
        const Case& known = shared.named().value;
        const TraceOptions how = trace_options(options, shared.named());
        return tracers.local()[options.methods[m]].trace(known.query, *known.truth.witness, how);
      },
      [&](const SharedCase& shared, size_t m, const Trace& trace) {
        session.show(TraceRow{shared.named().id, options.methods[m], trace}, m == 0, trace_cells);
      });
  session.end_table();
  return session.exit_code(kDone);
}

}  // namespace

void add_trace(CommandLine& line) {
  auto [command, options] = line.add<TraceArguments>(
      "trace", "Follow the witness of cases through the inclusion tests of methods", run_trace);
  command.texts("case", options->files, "Case files: .json, .jsonl or .jsonl.zst").required();
  add_methods(command, options->methods, "Methods to trace, separated by commas");
  options->search.add_precision_to(command);
  command.flag("--all", options->all,
               "Follow all pairs of boxes that contain the witness, not the lowest alone");
  command.threads();
  command.json("One JSON object per trace and line, with all details");
  command.max_work();
}

}  // namespace ccdfuzz
