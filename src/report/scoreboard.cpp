#include "report/scoreboard.hpp"

#include "query/line_reader.hpp"
#include "report/json_field.hpp"

namespace ccdfuzz {

namespace {

ScoreboardDriver scoreboard_driver(const JsonField& row) {
  ScoreboardDriver d;
  d.driver = row["driver"].text();
  d.faults = row["faults"].count();
  d.reached = row["reached"].count();
  d.triggered = row["triggered"].count();
  d.killed = row["killed"].count();
  if (d.killed > d.faults) row["killed"].refuse("is more than there are faults");
  d.clean_runs = row["clean_runs"].count();
  d.false_alarms = row["false_alarms"].count();
  if (d.false_alarms > d.clean_runs) row["false_alarms"].refuse("is more than there are runs");
  d.seconds = row["seconds"].amount();
  d.executions = row["executions"].amount();
  d.mean_seconds = row["mean_seconds"].amount();
  d.censored = row["censored"].truth();
  return d;
}

ScoreboardRow scoreboard_row(const JsonField& row) {
  ScoreboardRow r;
  r.driver = row["driver"].text();
  r.fault = row["fault"].text();
  r.what = row["what"].text();
  r.equivalent = row["equivalent"].truth();
  r.runs = row["runs"].count();
  r.reached = row["reached"].count();
  r.triggered = row["triggered"].count();
  r.detected = row["detected"].count();
  if (r.detected > r.runs) row["detected"].refuse("is more than there are runs");
  r.seconds = row["seconds"].amount();
  r.executions = row["executions"].amount();
  r.limit = row["limit"].amount();
  r.found = row["found"].text();
  return r;
}

}  // namespace

Result<Scoreboard> read_scoreboard(const std::string& path) {
  constexpr size_t kLongest = 16 << 20;  // a run of 200 faults has 0.2 MB
  auto file = LineReader::open(path, false, kLongest);
  if (!file) return tl::unexpected(file.error());
  const auto text = file->next(true);
  if (!text) return tl::unexpected(text.error());
  Scoreboard board;
  return read_fields(text->value_or(""), path,
                     [&](const JsonField& top) {
                       expect_format(top, "ccdfuzz-scoreboard");
                       for (const JsonField& row : top["drivers"].items()) {
                         board.drivers.push_back(scoreboard_driver(row));
                       }
                       for (const JsonField& row : top["rows"].items()) {
                         board.rows.push_back(scoreboard_row(row));
                       }
                     })
      .map([&] { return std::move(board); });
}

}  // namespace ccdfuzz
