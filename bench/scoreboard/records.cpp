#include "records.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <limits>

#include "fault_hash.hpp"
#include "io/json_tree.hpp"
#include "io/line_reader.hpp"
#include "io/output_file.hpp"
#include "record_line.hpp"

namespace ccdfuzz {

namespace {

const RunHeader kHeader = {"scoreboard", "", {}, {}, 0, {}};

/// The lines of the run file at the path, which a campaign may be writing.
Result<std::vector<std::string>> lines_of_run(const std::string& path) {
  CCDFUZZ_TRY(RunLines run, RunLines::open(path));
  if (const auto other = kHeader.difference(run.header())) return input_error(path, *other);
  std::vector<std::string> lines;
  for (;;) {
    CCDFUZZ_TRY(const auto line, run.next());
    if (!line) return lines;
    lines.emplace_back(*line);
  }
}

/// All that a file of records holds, each line ended, except one that was being written when its
/// writer ended.
Result<std::string> text_of(const std::string& path) {
  CCDFUZZ_TRY(auto file, LineReader::open(path, false, std::numeric_limits<std::size_t>::max()));
  CCDFUZZ_TRY(const auto whole, file.next(true));
  std::string text(whole.value_or(""));
  if (text.empty() || text.ends_with('\n')) return text;
  const std::size_t last = text.rfind('\n') + 1;  // npos + 1 is 0
  const bool finished = parse_json(std::string_view(text).substr(last), path).has_value();
  return finished ? text + '\n' : text.substr(0, last);
}

}  // namespace

Records::Records(const std::vector<PlantedFault>& faults) : faults_(&faults) {
  for (const PlantedFault& fault : faults) definitions_[fault.name] = definition_hash(fault);
  definitions_[kWatchedFaults] = definition_hash(faults);
}

Result<Records> Records::open(const std::string& path, const std::vector<PlantedFault>& faults,
                              Use use) {
  Records records(faults);
  if (path.empty()) return records;
  records.path_ = path;
  // The journal first: a campaign that ends meanwhile takes it away once the file has it all.
  const std::string journal_path = RunFile::path_for(path);
  const bool has_journal = std::filesystem::exists(journal_path);
  Result<std::vector<std::string>> journal;
  if (use == Use::kExtend) {
    journal = records.begin_journal();
  } else if (has_journal) {
    journal = lines_of_run(journal_path);
    if (!journal && !std::filesystem::exists(journal_path)) journal.emplace();
  }
  if (!journal) return tl::unexpected(journal.error());
  if (std::filesystem::exists(path) || (use == Use::kRead && !has_journal)) {
    if (auto read = records.read_file(); !read) {
      if (records.journal_ && journal->empty()) (void)records.journal_->remove();
      return tl::unexpected(read.error());
    }
  }
  CCDFUZZ_TRY_VOID(records.take_lines(*journal));
  return records;
}

Result<void> Records::read_file() {
  CCDFUZZ_TRY(const std::string text, text_of(path_));
  int number = 0;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = text.find('\n', begin);
    const std::string_view line = std::string_view(text).substr(begin, end - begin);
    CCDFUZZ_TRY(const auto record,
                parse_record(line, fmt::format("{}:{}", path_, ++number), *faults_));
    take(record);
    lines_.emplace(line);
    begin = end + 1;
  }
  return {};
}

Result<std::vector<std::string>> Records::begin_journal() {
  // That it can be written is asked now, and not when the campaign is over.
  CCDFUZZ_TRY_VOID(OutputFile::create(path_));
  CCDFUZZ_TRY(auto journal, RunFile::open(RunFile::path_for(path_), kHeader));
  journal_.emplace(std::move(journal));
  return lines_of_run(RunFile::path_for(path_));
}

Result<void> Records::take_lines(const std::vector<std::string>& journal) {
  for (const std::string& line : journal) {
    CCDFUZZ_TRY(const auto record, parse_record(line, RunFile::path_for(path_), *faults_));
    take(record);
    // Both have it where a campaign was interrupted between write_file and remove.
    if (!lines_.contains(line)) added_.append(line) += '\n';
  }
  return {};
}

void Records::take(const Record& record) {
  const Key key = {record.driver, record.fault, record.seed};
  const auto defined = definitions_.find(record.fault);
  const bool other = defined != definitions_.end() && !record.definition.empty() &&
                     record.definition != defined->second;
  if (other) {
    outdated_.insert(key);
  } else {
    records_[key] = record;
  }
}

const Record* Records::find(const std::string& driver, const std::string& fault, std::uint64_t seed,
                            double limit) const {
  const auto found = records_.find({driver, fault, seed});
  if (found == records_.end()) return nullptr;
  return found->second.detected || found->second.limit >= limit ? &found->second : nullptr;
}

Result<void> Records::add(Record record) {
  if (const auto d = definitions_.find(record.fault); d != definitions_.end()) {
    record.definition = d->second;
  }
  records_[{record.driver, record.fault, record.seed}] = record;
  if (!journal_) return {};
  const std::string line = to_line(record);
  added_.append(line) += '\n';
  return journal_->append(line);
}

Result<void> Records::finish() {
  if (!journal_) return {};
  if (!added_.empty()) {
    // What others may have put there meanwhile stays.
    CCDFUZZ_TRY(std::string text,
                std::filesystem::exists(path_) ? text_of(path_) : Result<std::string>(""));
    CCDFUZZ_TRY_VOID(write_file(path_, text + added_));
  }
  auto removed = journal_->remove();
  journal_.reset();
  return removed;
}

std::size_t Records::outdated() const {
  return static_cast<std::size_t>(
      std::ranges::count_if(outdated_, [&](const Key& key) { return !records_.contains(key); }));
}

}  // namespace ccdfuzz
