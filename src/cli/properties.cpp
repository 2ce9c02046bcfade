#include <fmt/format.h>

#include "base/text.hpp"
#include "cli/command.hpp"
#include "cli/session.hpp"
#include "properties/suites.hpp"

namespace ccdfuzz {

namespace {

struct PropertiesOptions {};

/// A property, as a row of the JSON output.
struct PropertyRow {
  const Property& property;

  static void fields(auto& archive, auto& row) {
    archive("property", std::string_view(row.property.name));
    archive("claim", std::string_view(row.property.claim));
    archive("source", std::string_view(row.property.source));
    archive("expected_to_fail", row.property.expected == Expectation::kFails);
  }
};

int run_properties(const PropertiesOptions&, Session& session) {
  for (const Property& property : properties()) {
    if (session.json) {
      print_row(PropertyRow{property});
      continue;
    }
    const bool known_false = property.expected == Expectation::kFails;
    const std::string head = fmt::format("{} ({}){}", property.name, property.source,
                                         known_false ? ", expected failure" : "");
    print_out(fmt::format("{}\n    {}\n", wrapped(head, 0), wrapped(property.claim, 4, 4)));
  }
  return kDone;
}

}  // namespace

void add_properties(CommandLine& line) {
  auto [command, options] = line.add<PropertiesOptions>(
      "properties", "List the properties that check tests, with their sources", run_properties);
  command.example("what names check takes", "properties");
  command.json("One JSON object per property");
}

}  // namespace ccdfuzz
