#include "cli/hunt_finds.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <optional>
#include <tuple>

#include "base/text.hpp"
#include "cli/output.hpp"
#include "cli/reproduction.hpp"

namespace ccdfuzz {

std::string command_of(const Find& find) {
  const std::string& method = find.failure.who;
  return reproduction(find.path, {{method, find.value.expect.at(method)}});
}

std::vector<const Find*> new_finds(const HuntReport& report, bool stored) {
  std::vector<const Find*> finds;
  for (const Find& find : report.finds) {
    if (find.is_new && find.path.empty() != stored) finds.push_back(&find);
  }
  // Those alike in the report's order, in which they lie.
  std::ranges::sort(finds, {}, [](const Find* find) {
    const Failure& failure = find->failure;
    return std::tuple(!breaks_claim(failure), failure.outcome == Outcome::kFalsePositive,
                      failure.setting, -find->depth, find);
  });
  return finds;
}

void print_finds(const std::vector<const Find*>& finds, const std::string& folder) {
  constexpr size_t kMost = 10;
  const auto alike = [](const Find& find) {
    Failure failure = find.failure;
    failure.contact.clear();
    return failure;
  };
  std::map<Failure, std::vector<std::string>> others;
  std::vector<const Find*> first;
  for (const Find* find : finds) {
    const auto [known, is_first] = others.try_emplace(alike(*find));
    if (is_first) first.push_back(find);
    if (!is_first) known->second.push_back(find->failure.contact);
  }
  std::optional<bool> group;
  for (size_t i = 0; i < std::min(first.size(), kMost); ++i) {
    const Find& find = *first[i];
    const bool breaks = breaks_claim(find.failure);
    if (group != breaks) {
      print_out(fmt::format("New in {}, breaking {} guarantee:\n", folder, breaks ? "a" : "no"));
    }
    group = breaks;
    std::string text = std::filesystem::path(find.path).filename().string();
    if (find.depth > 0) text += fmt::format(", {:.2g} deep", find.depth);
    const std::vector<std::string>& classes = others.at(alike(find));
    if (!classes.empty()) {
      text += fmt::format("; {} more: {}", classes.size(), fmt::join(classes, ", "));
    }
    print_out(wrapped("  " + text, 4) + "\n");
  }
  if (first.size() > kMost) print_out(fmt::format("  and {} more\n", first.size() - kMost));
  if (!finds.empty()) print_out("\n");
}

}  // namespace ccdfuzz
