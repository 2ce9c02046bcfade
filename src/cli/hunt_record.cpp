#include "cli/hunt_record.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <limits>

#include "base/fields.hpp"
#include "base/input_bytes.hpp"
#include "base/line_reader.hpp"
#include "base/output_file.hpp"
#include "cli/hunt_table.hpp"

namespace ccdfuzz {

namespace {

/// The first line of a record.
struct HuntHead {
  std::string command, store;
  double seconds = 0;
  std::vector<std::string> methods;

  static void fields(auto& archive, auto& head) {
    archive.format("ccdfuzz-hunt", 1, 1);
    archive("command", head.command);
    archive("store", head.store);
    archive("seconds", head.seconds, not_negative);
    archive("methods", head.methods);
  }
};

/// Where the store stands, seen from the folder of the record.
struct StoreRow {
  std::string from_record;

  static void fields(auto& archive, auto& row) {
    archive.constant("row", "store");
    archive("from_record", row.from_record);
  }
};

struct FindRow {
  std::string path;

  static void fields(auto& archive, auto& row) {
    archive.constant("row", "find");
    archive("path", row.path);
  }
};

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

/// Adds what the line says, which is not the first, to the record.
void read_row(const JsonCursor& row, HuntRecord& record, std::string& from_record) {
  const JsonCursor kind = row.at("row");
  if (kind.string() == "store") {
    from_record = read_json<StoreRow>(row).from_record;
  } else if (kind.string() == "plugin") {
    record.plugins.push_back(read_json<MethodInfo>(row));
  } else if (kind.string() == "cell") {
    record.cells.push_back(read_json<HuntCell>(row));
  } else if (kind.string() == "find") {
    record.finds.push_back(read_json<FindRow>(row).path);
  } else if (kind.string() == "sample") {
    record.course.samples.push_back(read_json<HuntSample>(row));
    row.at("margins").array(record.course.methods.size(), "items, one a method");
  } else {
    kind.refuse_value("is none of \"store\", \"plugin\", \"cell\", \"find\" and \"sample\"");
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
  const auto add = [&](const auto& row) { lines += to_json(row) + "\n"; };
  add(HuntHead{record.command, record.store, record.seconds, record.course.methods});
  for (const HuntCell& cell : record.cells) add(cell);
  const std::filesystem::path way = std::filesystem::proximate(record.store, folder, error);
  if (!error) add(StoreRow{way.string()});
  for (const MethodInfo& info : record.plugins) add(info);
  for (const std::string& path : record.finds) add(FindRow{path});
  for (const HuntSample& sample : record.course.samples) add(sample);
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
    const auto read = read_json_text(**line, where, [&](const JsonCursor& row) {
      if (lines->line() > 1) return read_row(row, record, from_record);
      auto head = read_json<HuntHead>(row);
      record.command = std::move(head.command);
      record.store = std::move(head.store);
      record.seconds = head.seconds;
      record.course.methods = std::move(head.methods);
    });
    if (!read) return tl::unexpected(read.error());
  }
  if (lines->line() == 0) return input_error(path, "is empty");
  if (!from_record.empty()) follow_store(folder, from_record, record);
  return record;
}

}  // namespace ccdfuzz
