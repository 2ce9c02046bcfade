#include "record_line.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "drivers.hpp"
#include "query/json_text.hpp"
#include "report/json_field.hpp"

namespace ccdfuzz {

namespace {

bool is_name_of_fault(const std::string& name, const std::vector<Fault>& faults) {
  return name == kNoFault || name == kWatchedFaults ||
         std::ranges::find(faults, name, &Fault::name) != faults.end();
}

Record read_record(const JsonField& line, const std::vector<Fault>& faults) {
  line.expect_only({"driver", "fault", "seed", "limit", "reached", "triggered", "detected",
                    "executions", "seconds", "found", "watched", "definition"});
  Record r;
  r.driver = line["driver"].text();
  if (!driver_named(r.driver)) line["driver"].refuse("is not a driver");
  r.fault = line["fault"].text();
  if (!is_name_of_fault(r.fault, faults)) {
    line["fault"].refuse(
        "is not in the list of faults; if it was taken from there, its records "
        "must go too");
  }
  r.seed = line["seed"].count();
  if (r.seed == 0) line["seed"].refuse("is not a seed; they begin at 1");
  r.limit = line["limit"].amount();
  if (r.limit == 0) line["limit"].refuse("is not a time limit");
  r.reached = line["reached"].count();
  r.triggered = line["triggered"].count();
  r.detected = line["detected"].truth();
  r.executions = line["executions"].count();
  r.seconds = line["seconds"].amount();
  r.found = line["found"].text();
  r.watched = line["watched"].truth();
  if (const auto definition = line.find("definition")) r.definition = definition->text();
  return r;
}

}  // namespace

std::string to_line(const Record& r) {
  nlohmann::ordered_json json = {
      {"driver", r.driver},     {"fault", r.fault},           {"seed", r.seed},
      {"limit", r.limit},       {"reached", r.reached},       {"triggered", r.triggered},
      {"detected", r.detected}, {"executions", r.executions}, {"seconds", r.seconds},
      {"found", r.found},       {"watched", r.watched}};
  if (!r.definition.empty()) json["definition"] = r.definition;
  return json_text(json);
}

Result<Record> parse_record(std::string_view line, const std::string& where,
                            const std::vector<Fault>& faults) {
  Record record;
  return read_fields(line, where, [&](const JsonField& top) { record = read_record(top, faults); })
      .map([&] { return record; });
}

}  // namespace ccdfuzz
