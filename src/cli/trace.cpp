#include <fmt/format.h>
#include <tbb/enumerable_thread_specific.h>

#include "ccd/witness_trace/trace.hpp"
#include "cli/command.hpp"
#include "cli/common_options.hpp"
#include "cli/output.hpp"
#include "cli/terminal.hpp"
#include "cli/trace_row.hpp"
#include "eval/by_spec.hpp"
#include "eval/in_order.hpp"

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

/// How each case is traced. Errors: a case without a witness within its step, naming it.
Result<std::vector<TraceOptions>> trace_options(const TraceArguments& options,
                                                const std::vector<NamedCase>& cases) {
  std::vector<TraceOptions> out;
  for (const NamedCase& named : cases) {
    const auto& witness = named.value.truth.witness;
    if (!witness) return input_error(named.id + ": truth.witness", "is missing: nothing to trace");
    if (witness->t > exact(named.value.query.t_max)) {
      return input_error(named.id + ": truth.witness.t",
                         fmt::format("{} is past t_max {}: nothing to trace", to_text(witness->t),
                                     named.value.query.t_max));
    }
    const Result<SearchOptions> own = options.search.parse_for(named);
    if (!own) return tl::unexpected(own.error());
    out.push_back({own->precision, options.all});
  }
  return out;
}

Result<int> run_trace(const TraceArguments& options) {
  const Result<std::vector<std::string>> methods = parse_method_list(options.methods);
  if (!methods) return tl::unexpected(methods.error());
  for (const std::string& method : *methods) {  // a plug-in has no tracer
    if (const auto tracer = make_tracer(method); !tracer) return tl::unexpected(tracer.error());
  }
  const Result<std::vector<NamedCase>> cases = read_all_checked(options.files);
  if (!cases) return tl::unexpected(cases.error());
  const Result<std::vector<TraceOptions>> how = trace_options(options, *cases);
  if (!how) return tl::unexpected(how.error());

  Table table = trace_table();
  Progress progress;
  tbb::enumerable_thread_specific<TracerSet> tracers;
  const size_t total = cases->size() * methods->size();
  size_t done = 0;
  run_in_order<Trace>(
      total, options.threads,
      [&](size_t i) {
        const size_t at = i / methods->size();
        const Case& known = (*cases)[at].value;
        return tracers.local()[(*methods)[i % methods->size()]].trace(
            known.query, *known.truth.witness, (*how)[at]);
      },
      [&](const Trace& trace) {
        const std::string& id = (*cases)[done / methods->size()].id;
        const std::string& method = (*methods)[done % methods->size()];
        if (options.json) {
          print_json(trace_row(id, method, trace));
        } else {
          if (done % methods->size() == 0) table.start_group();
          table.add_row(trace_cells(id, method, trace));
        }
        ++done;
        progress.show(static_cast<double>(done) / static_cast<double>(total), id, done, "traces");
      });
  progress.clear();
  if (!options.json) print_table(table);
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
