#include <fmt/format.h>

#include <sstream>

#include "cli/command.hpp"
#include "cli/output.hpp"
#include "properties/registry.hpp"

namespace ccdfuzz {

namespace {

struct PropertiesArguments {
  bool json = false;
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

Result<int> run_properties(const PropertiesArguments& options) {
  for (const Property& property : properties()) {
    const bool known_false = property.expected == Expectation::kFails;
    if (options.json) {
      print_json({{"property", property.name},
                  {"claim", property.claim},
                  {"source", property.source},
                  {"expected_to_fail", known_false}});
    } else {
      const std::string head = fmt::format("{} ({}){}", property.name, property.source,
                                           known_false ? ", known to be false" : "");
      print_out(wrapped(head, "") + wrapped(property.claim, "    "));
    }
  }
  return kDone;
}

}  // namespace

void add_properties(CommandLine& line) {
  auto [command, options] = line.add<PropertiesArguments>(
      "properties", "List the properties, with the claim and source of each", run_properties);
  command.flag("--json", options->json, "One JSON object per property");
}

}  // namespace ccdfuzz
