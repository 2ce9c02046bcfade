#include "records.hpp"

#include <fmt/format.h>

#include <fstream>
#include <nlohmann/json.hpp>

namespace ccdfuzz {

namespace {

nlohmann::ordered_json to_json(const Record& r) {
  return {{"driver", r.driver},     {"fault", r.fault},           {"seed", r.seed},
          {"limit", r.limit},       {"reached", r.reached},       {"triggered", r.triggered},
          {"detected", r.detected}, {"executions", r.executions}, {"seconds", r.seconds},
          {"found", r.found},       {"watched", r.watched}};
}

Record from_json(const nlohmann::json& j) {
  Record r;
  r.driver = j.at("driver"), r.fault = j.at("fault"), r.seed = j.at("seed");
  r.limit = j.at("limit"), r.reached = j.at("reached"), r.triggered = j.at("triggered");
  r.detected = j.at("detected"), r.executions = j.at("executions"), r.seconds = j.at("seconds");
  r.found = j.at("found"), r.watched = j.value("watched", false);
  return r;
}

}  // namespace

Result<Records> Records::open(const std::string& path) {
  Records records;
  records.path_ = path;
  std::ifstream in(path);
  int number = 0;
  for (std::string line; in && std::getline(in, line);) {
    ++number;
    try {
      const Record r = from_json(nlohmann::json::parse(line));
      records.records_[{r.driver, r.fault, r.seed}] = r;
    } catch (const nlohmann::json::exception& error) {
      return input_error(fmt::format("{}:{}", path, number), error.what());
    }
  }
  return records;
}

const Record* Records::find(const std::string& driver, const std::string& fault, std::uint64_t seed,
                            double limit) const {
  const auto found = records_.find({driver, fault, seed});
  if (found == records_.end()) return nullptr;
  return found->second.detected || found->second.limit >= limit ? &found->second : nullptr;
}

Result<void> Records::add(const Record& record) {
  records_[{record.driver, record.fault, record.seed}] = record;
  if (path_.empty()) return {};
  std::ofstream out(path_, std::ios::app);
  out << to_json(record).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace) << '\n';
  if (!out) return input_error(path_, "cannot be written");
  return {};
}

}  // namespace ccdfuzz
