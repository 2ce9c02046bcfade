#include <fmt/format.h>

#include <sstream>

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

constexpr size_t kColumns = 80;

/// The words in lines of at most kColumns, unless a word alone is longer, behind an indentation.
std::string wrapped(std::string_view text, std::string_view indentation) {
  std::string lines, line;
  std::istringstream words{std::string(text)};
  for (std::string word; words >> word;) {
    if (!line.empty() && indentation.size() + line.size() + 1 + word.size() > kColumns) {
      lines += fmt::format("{}{}\n", indentation, line);
      line.clear();
    }
    line += (line.empty() ? "" : " ") + word;
  }
  return lines + fmt::format("{}{}\n", indentation, line);
}

int run_properties(const PropertiesOptions&, Session& session) {
  for (const Property& property : properties()) {
    if (session.json) {
      print_row(PropertyRow{property});
      continue;
    }
    const bool known_false = property.expected == Expectation::kFails;
    const std::string head = fmt::format("{} ({}){}", property.name, property.source,
                                         known_false ? ", known to be false" : "");
    print_out(wrapped(head, "") + wrapped(property.claim, "    "));
  }
  return kDone;
}

}  // namespace

void add_properties(CommandLine& line) {
  auto [command, options] = line.add<PropertiesOptions>(
      "properties", "List the properties, with the claim and source of each", run_properties);
  command.json("One JSON object per property");
}

}  // namespace ccdfuzz
