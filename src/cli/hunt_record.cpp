#include "cli/hunt_record.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <limits>

#include "cli/hunt_table.hpp"
#include "query/input_bytes.hpp"
#include "query/json_text.hpp"
#include "query/line_reader.hpp"
#include "query/output_file.hpp"
#include "report/json_field.hpp"

namespace ccdfuzz {

namespace {

using RecordJson = nlohmann::ordered_json;

RecordJson sample_json(const HuntSample& sample) {
  RecordJson margins = RecordJson::array();
  for (const auto& margin : sample.margins) {
    margins.push_back(margin ? RecordJson(*margin) : RecordJson());
  }
  return {{"row", "sample"},           {"seconds", sample.seconds}, {"queries", sample.queries},
          {"mutants", sample.mutants}, {"finds", sample.finds},     {"margins", margins}};
}

std::optional<std::uint64_t> optional_count(const JsonField& field) {
  return field.is_null() ? std::nullopt : std::optional(field.count());
}

HuntCell cell_of(const JsonField& row) {
  HuntCell cell;
  cell.method = row["method"].text();
  const auto contact = contact_class_named(row["class"].text());
  if (!contact) row["class"].refuse("is no contact class");
  cell.contact = *contact;
  cell.tally.n = row["n"].count();
  cell.tally.positives = row["positives"].count();
  cell.tally.negatives = row["negatives"].count();
  for (const Outcome outcome : kAllOutcomes) {
    const std::string name(name_of(outcome));
    // Records written before methods could refuse do not have it.
    if (outcome == Outcome::kNotAsked && !row.find(name.c_str())) continue;
    cell.tally.by_outcome[static_cast<size_t>(outcome)] = row[name.c_str()].count();
  }
  cell.cpu_seconds = row["cpu_seconds"].amount();
  cell.bred.mutants = row["mutants"].count();
  cell.bred.lost = row["lost_mutants"].count();
  cell.bred.margin = optional_count(row["margin_ulps"]);
  return cell;
}

HuntSample sample_of(const JsonField& row, size_t methods) {
  HuntSample sample;
  sample.seconds = row["seconds"].amount();
  sample.queries = row["queries"].count();
  sample.mutants = row["mutants"].count();
  sample.finds = row["finds"].count();
  for (const JsonField& margin : row["margins"].items()) {
    sample.margins.push_back(optional_count(margin));
  }
  if (sample.margins.size() != methods) {
    row["margins"].refuse(fmt::format("has {} items, not one a method", sample.margins.size()));
  }
  return sample;
}

void read_head(const JsonField& row, HuntRecord& record) {
  expect_format(row, "ccdfuzz-hunt");
  record.command = row["command"].text();
  record.store = row["store"].text();
  record.seconds = row["seconds"].amount();
  for (const JsonField& method : row["methods"].items()) {
    record.course.methods.push_back(method.text());
  }
}

MethodInfo plugin_of(const JsonField& row) {
  MethodInfo info;
  info.spec = row["method"].text();
  info.source = row["source"].text();
  info.description = row["description"].text();
  info.claims_no_false_negative = row["claims_no_false_negative"].truth();
  return info;
}

/// The store and what was found in it as they stand seen from here: as the hunt was told, unless
/// the record has been moved and the store with it. from_record: the way from one to the other.
void follow_store(const std::string& folder, const std::string& from_record, HuntRecord& record) {
  namespace fs = std::filesystem;
  std::error_code error;
  const fs::path beside = fs::canonical(fs::path(folder) / from_record, error);
  if (error || fs::equivalent(beside, record.store, error)) return;
  for (std::string& path : record.finds) {
    path = (beside / fs::path(path).lexically_relative(record.store)).string();
  }
  record.store = beside.string();
}

void read_row(const JsonField& row, HuntRecord& record, std::string& from_record) {
  const std::string& kind = row["row"].text();
  if (kind == "store") {
    from_record = row["from_record"].text();
  } else if (kind == "plugin") {
    record.plugins.push_back(plugin_of(row));
  } else if (kind == "cell") {
    record.cells.push_back(cell_of(row));
  } else if (kind == "find") {
    record.finds.push_back(row["path"].text());
  } else if (kind == "sample") {
    record.course.samples.push_back(sample_of(row, record.course.methods.size()));
  } else {
    row["row"].refuse("is none of \"store\", \"plugin\", \"cell\", \"find\" and \"sample\"");
  }
}

}  // namespace

std::string hunt_record_path(const std::string& folder) {
  return folder + "/hunt.jsonl";
}

Result<void> write_hunt_record(const std::string& folder, const HuntRecord& record) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) return input_error(folder, "cannot make the folder: " + error.message());
  std::string lines;
  const auto add = [&](const RecordJson& row) { lines += json_text(row) + "\n"; };
  add({{"format", "ccdfuzz-hunt"},
       {"version", 1},
       {"command", record.command},
       {"store", record.store},
       {"seconds", record.seconds},
       {"methods", record.course.methods}});
  for (const HuntCell& cell : record.cells) add(cell_json(cell));
  const std::filesystem::path way = std::filesystem::proximate(record.store, folder, error);
  if (!error) add({{"row", "store"}, {"from_record", way.string()}});
  for (const MethodInfo& info : record.plugins) {
    add({{"row", "plugin"},
         {"method", info.spec},
         {"source", info.source},
         {"description", info.description},
         {"claims_no_false_negative", info.claims_no_false_negative}});
  }
  for (const std::string& path : record.finds) add({{"row", "find"}, {"path", path}});
  for (const HuntSample& sample : record.course.samples) add(sample_json(sample));
  return write_file(hunt_record_path(folder), lines);
}

Result<HuntRecord> read_hunt_record(const std::string& folder) {
  const std::string path = hunt_record_path(folder);
  auto lines = refuse_irregular(path).and_then(
      [&] { return LineReader::open(path, false, std::numeric_limits<size_t>::max()); });
  if (!lines) return tl::unexpected(lines.error());
  HuntRecord record;
  std::string from_record;
  for (;;) {
    const auto line = lines->next();
    if (!line) return tl::unexpected(line.error());
    if (!*line) break;
    const std::string where = fmt::format("{}:{}", path, lines->line());
    const auto read = read_fields(**line, where, [&](const JsonField& row) {
      lines->line() == 1 ? read_head(row, record) : read_row(row, record, from_record);
    });
    if (!read) return tl::unexpected(read.error());
  }
  if (lines->line() == 0) return input_error(path, "is empty");
  if (!from_record.empty()) follow_store(folder, from_record, record);
  return record;
}

}  // namespace ccdfuzz
