#include <fmt/format.h>

#include <optional>
#include <utility>

#include "ccd/witness_trace/trace.hpp"
#include "cli/command.hpp"
#include "cli/common_options.hpp"
#include "cli/session.hpp"
#include "cli/shared_case.hpp"
#include "method/by_spec.hpp"

namespace ccdfuzz {

namespace {

std::array<double, 3> coordinates(const Vec3<double>& v) {
  return {v[0], v[1], v[2]};
}

struct TimesJson {
  const SeparatedInterval<double>& times;

  static void fields(auto& archive, auto& json) {
    archive("from", json.times.lo);
    archive("to", json.times.hi);
    archive("has_from", json.times.has_lo);
    archive("has_to", json.times.has_hi);
  }
};

void place_fields(JsonWriter& archive, const TracePlace& place) {
  archive("level", place.level);
  archive("cells", place.cells);
  archive("window", std::array{place.window.lo, place.window.hi});
}

/// The fields of an axis that excluded something (ExcludedInterval), or how far it is from that
/// (SignedGap).
void axis_fields(JsonWriter& archive, const auto& by) {
  archive("axis", by.axis);
  archive("direction", coordinates(by.direction));
  archive("below", by.below);
}

void exclusion_fields(JsonWriter& archive, const ExcludedInterval& by) {
  axis_fields(archive, by);
  archive("excluded", TimesJson{by.times});
}

}  // namespace

template <>
struct JsonForm<Cell> {
  static void fields(auto& archive, auto& cell) {
    archive("i", cell.i);
    archive("j", cell.j);
    archive("depth", cell.depth);
    archive("inverted", cell.inverted);
  }
};

template <>
struct JsonForm<Trace::Loss> {
  static void fields(auto& archive, auto& loss) {
    place_fields(archive, loss.place);
    exclusion_fields(archive, loss.by);
    std::optional<std::array<double, 2>> left;
    if (loss.left) left = {loss.left->lo, loss.left->hi};
    archive("left", left);
  }
};

template <>
struct JsonForm<Trace::Margin> {
  static void fields(auto& archive, auto& margin) {
    archive("ulps", margin.ulps);
    place_fields(archive, margin.place);
    exclusion_fields(archive, margin.by);
  }
};

template <>
struct JsonForm<Trace::Slack> {
  static void fields(auto& archive, auto& slack) {
    archive("value", slack.value);
    place_fields(archive, slack.place);
    axis_fields(archive, slack.gap);
    archive("gap", std::array{slack.gap.at_lo, slack.gap.at_hi});
    archive("unit", slack.gap.in_units_of);
  }
};

namespace {

/// How a method's tests treated the witness of a case.
struct TraceRow {
  const std::string& id;
  const std::string& method;
  const Trace& trace;

  /// All that Trace holds, under its own names. loss, margin and slack are null where there is
  /// none.
  static void fields(auto& archive, auto& row) {
    const Trace& trace = row.trace;
    archive("case", row.id);
    archive("method", row.method);
    archive("lost", trace.lost);
    archive("pairs", trace.pairs);
    archive("lost_pairs", trace.lost_pairs);
    archive("false_claims", trace.false_claims);
    archive("levels", trace.levels);
    archive("loss", trace.loss);
    archive("margin", trace.margin);
    archive("slack", trace.slack);
  }
};

std::vector<Table::Column> trace_columns() {
  return {method_column(),
          {"witness", Align::kLeft},
          {"level"},
          {"axis"},
          {"below", Align::kLeft},
          {"margin"},
          {"slack"},
          {"pairs"}};
}

/// One line for people. Level and axis are those of the loss, or of the smallest margin if kept.
std::vector<TableCell> trace_cells(const TraceRow& row) {
  const Trace& trace = row.trace;
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
  return {{marked(row.method)},
          {trace.lost ? "lost" : "kept", trace.lost ? Emphasis::kBad : Emphasis::kPlain},
          level,
          axis,
          below,
          margin,
          slack,
          {pairs}};
}

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
  const bool is_default = options.methods == default_methods();
  std::uint64_t cases = 0, traces = 0, lost = 0, refused = 0;
  tbb::enumerable_thread_specific<TracerSet> tracers;
  std::optional<std::string> title;  // of a case of which nothing is shown yet
  session.each_case<SharedCase, std::optional<Trace>>(
      CaseStream(options.files), options.methods.size(), "traces",
      [&](SharedCase& shared, size_t m) -> std::optional<Trace> {
        need(shared.checked());
        const Case& known = shared.named().value;
        const TraceOptions how = trace_options(options, shared.named());
        if (is_of_bodies(known.query)) {
          throw BadInput{{shared.named().id,
                          "is of bodies, which have no boxes to trace; patches are accepted"}};
        }
        const Result<void> taken = check_taken(options.methods[m], known.query);
        if (!taken && is_default) return std::nullopt;
        need(taken);
        return tracers.local()[options.methods[m]].trace(known.query, *known.truth.witness, how);
      },
      [&](const SharedCase& shared, size_t m, const std::optional<Trace>& trace) {
        const std::string& id = shared.named().id;
        cases += m == 0 ? 1 : 0;
        if (m == 0) title = id;
        if (!trace) {
          ++refused;
          return;
        }
        ++traces;
        lost += trace->lost ? 1 : 0;
        session.show(TraceRow{id, options.methods[m], *trace}, std::exchange(title, std::nullopt),
                     trace_cells);
      });
  session.end_table(true);
  session.summary(
      mark_note(options.methods) +
      fmt::format("{}, {}: {} lost", counted(cases, "case", "cases"),
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
  command.json("One JSON object per trace and line, with all details");
}

}  // namespace ccdfuzz
