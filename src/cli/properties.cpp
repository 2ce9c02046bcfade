#include "cli/command.hpp"
#include "cli/output.hpp"
#include "cli/terminal.hpp"
#include "eval/table.hpp"
#include "properties/registry.hpp"

namespace ccdfuzz {

namespace {

struct PropertiesArguments {
  bool json = false;
};

Result<int> run_properties(const PropertiesArguments& options) {
  Table table({{"property", Align::kLeft},
               {"claim", Align::kLeft},
               {"source", Align::kLeft},
               {"", Align::kLeft}});
  for (const Property& property : properties()) {
    const bool known_false = property.expected == Expectation::kFails;
    if (options.json) {
      print_json({{"property", property.name},
                  {"claim", property.claim},
                  {"source", property.source},
                  {"expected_to_fail", known_false}});
    } else {
      table.add_row({{std::string(property.name)},
                     {std::string(property.claim)},
                     {std::string(property.source)},
                     {known_false ? "known to be false" : ""}});
    }
  }
  if (!options.json) print_out(table.to_text(wants_colour(stdout)));
  return kDone;
}

}  // namespace

void add_properties(CommandLine& line) {
  auto [command, options] = line.add<PropertiesArguments>(
      "properties", "List the properties, with the claim and source of each", run_properties);
  command.flag("--json", options->json, "One JSON object per property");
}

}  // namespace ccdfuzz
