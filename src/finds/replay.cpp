#include "finds/replay.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "finds/entries.hpp"

namespace ccdfuzz {

size_t ReplayReport::changed() const {
  return static_cast<size_t>(
      std::count_if(rows.begin(), rows.end(), [](const ReplayRow& row) { return row.changed(); }));
}

std::string to_text(const ReplayRow& row) {
  return fmt::format("{}: {}: expected {}, got {}", row.id, row.method, name_of(row.expected),
                     name_of(row.got.outcome));
}

Result<ReplayReport> replay(const std::vector<NamedCase>& entries, const AskFunction& ask_method) {
  if (entries.empty()) return input_error("", "the corpus is empty");
  ReplayReport report;
  for (const NamedCase& entry : entries) {
    ++report.entries;
    if (entry.value.expect.empty()) ++report.without_expectation;
    for (const auto& [method, expected] : entry.value.expect) {
      auto judged = ask_method(method, entry);
      if (!judged) {
        return input_error(fmt::format("{}: expect[\"{}\"]", entry.id, method),
                           judged.error().message());
      }
      report.rows.push_back({entry.id, method, expected.outcome, *std::move(judged)});
    }
  }
  return report;
}

Result<ReplayReport> replay(const std::string& corpus, const AskFunction& ask_method) {
  return load_corpus(corpus).and_then(
      [&](const std::vector<NamedCase>& entries) { return replay(entries, ask_method); });
}

}  // namespace ccdfuzz
