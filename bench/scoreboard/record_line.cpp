#include "record_line.hpp"

#include <algorithm>

#include "drivers.hpp"
#include "io/fields.hpp"

namespace ccdfuzz {

namespace {

bool is_name_of_fault(const std::string& name, const std::vector<PlantedFault>& faults) {
  return name == kNoFault || name == kWatchedFaults ||
         std::ranges::find(faults, name, &PlantedFault::name) != faults.end();
}

}  // namespace

std::string to_line(const Record& record) {
  return to_json(record);
}

Result<Record> parse_record(std::string_view line, const std::string& where,
                            const std::vector<PlantedFault>& faults) {
  Record record;
  return read_json_text(line, where,
                        [&](const JsonCursor& top) {
                          read_json(top, record);
                          if (!driver_named(record.driver))
                            top.at("driver").refuse_value("is not a driver");
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

}  // namespace ccdfuzz
