#include "records.hpp"

#include <fmt/format.h>
#include <xxhash.h>

#include <algorithm>

namespace ccdfuzz {

namespace {

const RunHeader kHeader = {"scoreboard", "", {}, {}, 0, {}};

std::string hash_of(const std::string& text) {
  return fmt::format("{:08x}", XXH3_64bits(text.data(), text.size()) >> 32);
}

/// A hash of all faults of a list, in their order.
std::string hash_of(const std::vector<PlantedFault>& faults) {
  std::string all;
  for (const PlantedFault& fault : faults) all += definition_hash(fault) + " " + fault.name + "\n";
  return hash_of(all);
}

bool is_name_of_fault(const std::string& name, const std::vector<PlantedFault>& faults) {
  return name == kNoFault || name == kWatchedFaults ||
         std::ranges::find(faults, name, &PlantedFault::name) != faults.end();
}

Result<Record> parse_record(std::string_view line, const std::string& where,
                            const std::vector<PlantedFault>& faults) {
  Record record;
  return read_json_text(line, where,
                        [&](const JsonCursor& top) {
                          read_json(top, record);
                          if (!is_name_of_fault(record.fault, faults)) {
                            top.at("fault").refuse_value(
                                "is not in the list of faults; if it was taken from there, its "
                                "records must go too");
                          }
                          if (record.seed == 0)
                            top.at("seed").refuse_value("is not a seed; they begin at 1");
                        })
      .map([&] { return record; });
}

}  // namespace

std::string definition_hash(const PlantedFault& fault) {
  return hash_of(fmt::format("{}\n{}\n{}\n{}", fault.file, fault.statement ? "stmt" : "expr",
                             fault.from, fault.to));
}

Records::Records(const std::vector<PlantedFault>& faults) {
  for (const PlantedFault& fault : faults) definitions_[fault.name] = definition_hash(fault);
  definitions_[kWatchedFaults] = hash_of(faults);
}

Result<Records> Records::open(const std::string& path, const std::vector<PlantedFault>& faults,
                              Use use) {
  Records records(faults);
  if (path.empty()) return records;
  if (use == Use::kExtend) {
    CCDFUZZ_TRY(auto file, RunFile::open(path, kHeader));
    records.file_.emplace(std::move(file));
  }
  CCDFUZZ_TRY(RunLines run, RunLines::open(path));
  if (const auto other = kHeader.difference(run.header())) return input_error(path, *other);
  for (;;) {
    CCDFUZZ_TRY(const auto line, run.next());
    if (!line) return records;
    CCDFUZZ_TRY(const auto record, parse_record(*line, run.where(), faults));
    records.take(record);
  }
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

const Record* Records::find(Driver driver, const std::string& fault, std::uint64_t seed,
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
  return file_ ? file_->append(to_json(record)) : Result<void>();
}

std::size_t Records::outdated() const {
  return static_cast<std::size_t>(
      std::ranges::count_if(outdated_, [&](const Key& key) { return !records_.contains(key); }));
}

}  // namespace ccdfuzz
