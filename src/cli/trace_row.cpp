#include "cli/trace_row.hpp"

#include <fmt/format.h>

#include <array>
#include <optional>

#include "base/fields.hpp"

namespace ccdfuzz {

namespace {

std::array<double, 3> coordinates(const Vec3<double>& v) {
  return {v[0], v[1], v[2]};
}

struct TimesJson {
  const Separation<double>& times;

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

/// Of an axis that excluded something (Exclusion), or how far it is from that (AxisGap).
void axis_fields(JsonWriter& archive, const auto& by) {
  archive("axis", by.axis);
  archive("direction", coordinates(by.direction));
  archive("below", by.below);
}

void exclusion_fields(JsonWriter& archive, const Exclusion& by) {
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
    archive("unit", slack.gap.unit);
  }
};

template <>
struct JsonForm<TraceRow> {
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

std::string to_json(const TraceRow& row) {
  std::string json;
  write_json(json, row);
  return json;
}

std::vector<Table::Column> trace_columns() {
  return {{"case", Align::kLeft},
          {"method", Align::kLeft},
          {"witness", Align::kLeft},
          {"level"},
          {"axis"},
          {"below", Align::kLeft},
          {"margin"},
          {"slack"},
          {"pairs"}};
}

std::vector<TableCell> trace_cells(const TraceRow& row) {
  const Trace& trace = row.trace;
  TableCell level, axis, below, margin, slack;
  const auto show = [&](const TracePlace& place, const Exclusion& by) {
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
  return {{row.id},
          {row.method},
          {trace.lost ? "lost" : "kept", trace.lost ? Emphasis::kBad : Emphasis::kPlain},
          level,
          axis,
          below,
          margin,
          slack,
          {pairs}};
}

}  // namespace ccdfuzz
