#include "cli/trace_row.hpp"

#include <fmt/format.h>

namespace ccdfuzz {

namespace {

using Json = nlohmann::ordered_json;

Json to_row(const Vec3<double>& v) {
  return {v[0], v[1], v[2]};
}

Json to_row(const TracePlace& place) {
  Json cells = Json::array();
  for (const Cell& cell : place.cells) {
    cells.push_back(
        {{"i", cell.i}, {"j", cell.j}, {"depth", cell.depth}, {"inverted", cell.inverted}});
  }
  return {{"level", place.level}, {"cells", cells}, {"window", {place.window.lo, place.window.hi}}};
}

void add(Json& row, const Exclusion& by) {
  row["axis"] = by.axis;
  row["direction"] = to_row(by.direction);
  row["below"] = by.below;
  row["excluded"] = {{"from", by.times.lo},
                     {"to", by.times.hi},
                     {"has_from", by.times.has_lo},
                     {"has_to", by.times.has_hi}};
}

Json loss_row(const Trace::Loss& loss) {
  Json row = to_row(loss.place);
  add(row, loss.by);
  row["left"] = nullptr;
  if (loss.left) row["left"] = {loss.left->lo, loss.left->hi};
  return row;
}

Json margin_row(const Trace::Margin& margin) {
  Json row = {{"ulps", margin.ulps}};
  row.update(to_row(margin.place));
  add(row, margin.by);
  return row;
}

Json slack_row(const Trace::Slack& slack) {
  Json row = {{"value", slack.value}};
  row.update(to_row(slack.place));
  row["axis"] = slack.gap.axis;
  row["direction"] = to_row(slack.gap.direction);
  row["below"] = slack.gap.below;
  row["gap"] = {slack.gap.at_lo, slack.gap.at_hi};
  row["unit"] = slack.gap.unit;
  return row;
}

}  // namespace

Json trace_row(const std::string& case_id, const std::string& method, const Trace& trace) {
  Json row = {{"case", case_id},
              {"method", method},
              {"lost", trace.lost},
              {"pairs", trace.pairs},
              {"lost_pairs", trace.lost_pairs},
              {"false_claims", trace.false_claims},
              {"levels", trace.levels},
              {"loss", nullptr},
              {"margin", nullptr},
              {"slack", nullptr}};
  if (trace.loss) row["loss"] = loss_row(*trace.loss);
  if (trace.margin) row["margin"] = margin_row(*trace.margin);
  if (trace.slack) row["slack"] = slack_row(*trace.slack);
  return row;
}

Table trace_table() {
  return Table({{"case", Align::kLeft},
                {"method", Align::kLeft},
                {"witness", Align::kLeft},
                {"level"},
                {"axis"},
                {"below", Align::kLeft},
                {"margin"},
                {"slack"},
                {"pairs"}});
}

std::vector<TableCell> trace_cells(const std::string& case_id, const std::string& method,
                                   const Trace& trace) {
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
  return {{case_id},
          {method},
          {trace.lost ? "lost" : "kept", trace.lost ? Emphasis::kBad : Emphasis::kPlain},
          level,
          axis,
          below,
          margin,
          slack,
          {pairs}};
}

}  // namespace ccdfuzz
