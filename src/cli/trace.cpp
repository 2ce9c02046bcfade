#include <fmt/format.h>

#include <optional>

#include "ccd/witness_trace/trace.hpp"
#include "cli/command.hpp"
#include "cli/common_options.hpp"
#include "cli/session.hpp"
#include "method/ask.hpp"

namespace ccdfuzz {

namespace {

/// One line for people. Level and axis are those of the loss, or of the smallest margin if kept.
std::vector<TableCell> trace_cells(const std::string& method, const Trace& trace) {
  TableCell level, axis, below, margin, slack;
  const auto show = [&](const TracePlace& place, const ExcludedInterval& by) {
    level = {fmt::format("{}", place.level)};
    axis = {fmt::format("{}", by.axis)};
    below = {by.below == 0 ? "first" : "second"};
  };
  if (trace.loss) {
    show(trace.loss->place, trace.loss->by);
  } else if (trace.margin) {
    show(trace.margin->place, trace.margin->by);
    margin = {fmt::format("{}", trace.margin->ulps)};
  }
  if (trace.slack) slack = {fmt::format("{:.3g}", trace.slack->value)};
  const std::string pairs = trace.lost_pairs == 0
                                ? fmt::format("{}", trace.pairs)
                                : fmt::format("{} of {} lost", trace.lost_pairs, trace.pairs);
  return {{marked(method)},
          {trace.lost ? "lost" : "kept", trace.lost},
          level,
          axis,
          below,
          margin,
          slack,
          {pairs}};
}

/// Shows how a method's tests treated the witness of a case.
void show_trace(const std::string& id, const std::string& method, const Trace& trace,
                Session& session) {
  // The axis that lost the contact, or came nearest to that; a page (report) has its cells, too.
  const auto add_axis = [](auto& row, const TracePlace& place, const auto& by) {
    row("level", place.level);
    row("axis", by.axis);
    row("below", by.below);
    if constexpr (requires { by.times; }) row("excluded", std::array{by.times.lo, by.times.hi});
  };
  const auto loss = [&](auto& row) { add_axis(row, trace.loss->place, trace.loss->by); };
  const auto margin = [&](auto& row) {
    add_axis(row, trace.margin->place, trace.margin->by);
    row("ulps", trace.margin->ulps);
  };
  const auto slack = [&](auto& row) {
    add_axis(row, trace.slack->place, trace.slack->gap);
    row("slack", trace.slack->value);
  };
  const auto row = [&](auto& archive) {
    archive("case", id);
    archive("method", method);
    archive("lost", trace.lost);
    archive("pairs", trace.pairs);
    archive("lost_pairs", trace.lost_pairs);
    archive("false_claims", trace.false_claims);
    archive("levels", trace.levels);
    archive("loss", trace.loss ? std::optional(loss) : std::nullopt);
    archive("margin", trace.margin ? std::optional(margin) : std::nullopt);
    archive("slack", trace.slack ? std::optional(slack) : std::nullopt);
  };
  session.show(row, [&] { return trace_cells(method, trace); });
}

struct TraceArguments {
  std::vector<std::string> files;
  std::vector<std::string> methods = default_methods();
  SearchFlags search;
  bool all = false;
};

/// What is shown of a case: a trace of each method that takes it, or why none is made.
struct Traced {
  std::vector<std::optional<Trace>> by_methods = {};
  std::optional<InputError> why_not = {};
};

/// Why no method can be traced on a case, if so.
std::optional<InputError> untraced(const NamedCase& named) {
  const Query& query = named.value.query;
  const auto& witness = named.value.truth.witness;
  if (!witness) return InputError{named.id + ": truth.witness", "is missing: nothing to trace"};
  if (witness->t > exact(query.t_max)) {
    return InputError{
        named.id + ": truth.witness.t",
        fmt::format("{} is past t_max {}: nothing to trace", to_text(witness->t), query.t_max)};
  }
  if (!is_of_bodies(query)) return std::nullopt;
  return InputError{named.id, "is of bodies, which have no boxes to trace; patches are accepted"};
}

int run_trace(const TraceArguments& options, Session& session) {
  for (const std::string& method : options.methods) {
    if (need(make_method(method))->is_traceable()) continue;
    throw BadInput{{"--methods", fmt::format("\"{}\" is a plug-in: what it does inside cannot be "
                                             "traced",
                                             method)}};
  }
  session.begin_table({method_column(),
                       {"witness", Align::kLeft},
                       {"level"},
                       {"axis"},
                       {"below", Align::kLeft},
                       {"margin"},
                       {"slack"},
                       {"pairs"}});
  std::uint64_t traces = 0, lost = 0, refused = 0, left_out = 0;
  std::optional<InputError> first_why_not;
  tbb::enumerable_thread_specific<MethodSet> methods;
  session.each_case<Traced>(
      CaseStream(options.files),
      [&](NamedCase& named) -> Traced {
        need(decided_and_checked(named));
        Traced made{.why_not = untraced(named)};
        if (made.why_not) return made;
        const Case& known = named.value;
        const TraceOptions how = {options.search.options_for(known).precision, options.all};
        for (const std::string& method : options.methods) {
          const Result<void> taken = check_taken(method, known.query);
          std::optional<Trace>& trace = made.by_methods.emplace_back();
          if (taken) trace = methods.local()[method].trace(known.query, *known.truth.witness, how);
          if (!taken) made.why_not = taken.error();
        }
        return made;
      },
      [&](const NamedCase& named, const Traced& traced) {
        const bool is_first = traced.by_methods.empty() ? left_out++ == 0 : !first_why_not;
        if (is_first) first_why_not = traced.why_not;
        session.start_group(named.id);
        for (size_t m = 0; m < traced.by_methods.size(); ++m) {
          const std::optional<Trace>& trace = traced.by_methods[m];
          ++(trace ? traces : refused);
          if (!trace) continue;
          lost += trace->lost ? 1 : 0;
          show_trace(named.id, options.methods[m], *trace, session);
        }
      });
  if (traces == 0 && first_why_not) throw BadInput{*first_why_not};
  session.end_table(true);
  if (left_out > 0) {
    session.remark("{} left out, such as {}", counted(left_out, "case", "cases"),
                   first_why_not->message());
  }
  session.summary(
      mark_note(options.methods) +
      fmt::format("{}, {}: {} lost", counted(session.counts.cases, "case", "cases"),
                  counted(traces, "witness followed", "witnesses followed"), lost) +
      (refused == 0 ? "" : fmt::format("; {} not asked: a method refuses the query", refused)));
  return session.exit_code(kDone);
}

}  // namespace

void add_trace(CommandLine& line) {
  auto [command, options] = line.add<TraceArguments>(
      "trace", "Show where methods lose a contact that is known", run_trace);
  command.example("how a method came to miss a contact", "trace finds/FIND.json --methods tdibm");
  command.texts("case", options->files, "Case files: .json, .jsonl, .jsonl.zst or .csv").required();
  add_methods(command, options->methods, "Methods to trace, separated by commas");
  options->search.add_precision_to(command);
  command.flag("--all", options->all,
               "Follow all pairs of boxes that contain the witness, not the lowest alone");
  command.max_work();
  command.threads();
  command.json("One JSON object per trace and line");
}

}  // namespace ccdfuzz
