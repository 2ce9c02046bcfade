#include <fmt/format.h>
#include <tbb/enumerable_thread_specific.h>

#include "ccd/witness_trace/trace.hpp"
#include "cli/command.hpp"
#include "cli/common_options.hpp"
#include "cli/output.hpp"
#include "cli/shared_case.hpp"
#include "cli/terminal.hpp"
#include "cli/trace_row.hpp"
#include "eval/by_spec.hpp"
#include "eval/stream_cases.hpp"

namespace ccdfuzz {

namespace {

struct TraceArguments {
  std::vector<std::string> files;
  std::string methods = kDefaultMethods;
  SearchFlags search;
  int threads = 1;
  bool all = false;
  bool json = false;
};

/// How a case is traced. Errors: a case without a witness within its step, naming it.
Result<TraceOptions> trace_options(const TraceArguments& options, const NamedCase& named) {
  const auto& witness = named.value.truth.witness;
  if (!witness) return input_error(named.id + ": truth.witness", "is missing: nothing to trace");
  if (witness->t > exact(named.value.query.t_max)) {
    return input_error(named.id + ": truth.witness.t",
                       fmt::format("{} is past t_max {}: nothing to trace", to_text(witness->t),
                                   named.value.query.t_max));
  }
  return options.search.parse_for(named).map([&](const SearchOptions& own) {
    return TraceOptions{own.precision, options.all};
  });
}

Result<int> run_trace(const TraceArguments& options) {
  const Result<std::vector<std::string>> methods = parse_method_list(options.methods);
  if (!methods) return tl::unexpected(methods.error());
  for (const std::string& method : *methods) {  // a plug-in has no tracer
    if (const auto tracer = make_tracer(method); !tracer) return tl::unexpected(tracer.error());
  }
  if (const auto search = options.search.parse(); !search) return tl::unexpected(search.error());
  Table table = trace_table();
  Progress progress;
  tbb::enumerable_thread_specific<TracerSet> tracers;
  std::uint64_t done = 0;
  const Result<void> read = stream_cases<SharedCase, Trace>(
      options.files, methods->size(), options.threads,
      [&](SharedCase& shared, size_t m) -> Result<Trace> {
        if (const auto& checked = shared.checked(); !checked) {
          return tl::unexpected(checked.error());
        }
        return trace_options(options, shared.named()).map([&](const TraceOptions& how) {
          const Case& known = shared.named().value;
          return tracers.local()[(*methods)[m]].trace(known.query, *known.truth.witness, how);
        });
      },
      [&](const SharedCase& shared, size_t m, const Trace& trace, double share) {
        const std::string& id = shared.named().id;
        if (options.json) {
          print_json(trace_row(id, (*methods)[m], trace));
        } else {
          if (m == 0) {
            print_full_rows(table);
            table.start_group();
          }
          table.add_row(trace_cells(id, (*methods)[m], trace));
        }
        progress.show(share, id, ++done, "traces");
      });
  progress.clear();
  if (table.row_count() > 0) print_last_rows(table);
  if (!read) return tl::unexpected(read.error());
  return kDone;
}

}  // namespace

void add_trace(CommandLine& line) {
  auto [command, options] = line.add<TraceArguments>(
      "trace", "Follow the witness of cases through the inclusion tests of methods", run_trace);
  command.texts("case", options->files, "Case files: .json, .jsonl or .jsonl.zst").required();
  command.text("--methods", options->methods, "Methods to trace, separated by commas");
  options->search.add_precision_to(command);
  command.flag("--all", options->all,
               "Follow all pairs of boxes that contain the witness, not the lowest alone");
  add_threads(command, options->threads);
  command.flag("--json", options->json, "One JSON object per trace and line, with all details");
}

}  // namespace ccdfuzz
