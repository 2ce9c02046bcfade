#include <fmt/format.h>

#include "base/text.hpp"
#include "cli/command.hpp"
#include "cli/session.hpp"

namespace ccdfuzz {

namespace {

struct PropertiesOptions {};

int run_properties(const PropertiesOptions&, Session& session) {
  for (const Property& property : session.properties) {
    const bool known_false = property.expected == Expectation::kFails;
    const auto row = [&](auto& archive) {
      archive("property", std::string_view(property.name));
      archive("claim", std::string_view(property.claim));
      archive("source", std::string_view(property.source));
      archive("expected_to_fail", known_false);
      archive.optional("any_method", property.check_of != nullptr);
    };
    const std::string head = fmt::format("{} ({}){}", property.name, property.source,
                                         known_false ? ", expected failure" : "");
    session.say(row, fmt::format("{}\n    {}\n", wrapped(head, 0), wrapped(property.claim, 4, 4)));
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
