#include "corpus_driver.hpp"

#include <fmt/format.h>

#include "files/check_file.hpp"
#include "finds/entries.hpp"
#include "method/ask.hpp"

namespace ccdfuzz {

CorpusDriver::CorpusDriver(const std::string& corpus) {
  const Result<void> read = for_each_entry(corpus, [this](const NamedCase& entry) {
    // Those that were found at a precision of their own are not asked here.
    if (entry.value.asked == Asked()) entries_.push_back(entry);
  });
  if (read) return;
  trouble_ = read.error().message();
  entries_.resize(1);
}

std::string CorpusDriver::operator()(std::uint64_t index) {
  if (!trouble_.empty()) return trouble_;
  const NamedCase& entry = entries_[index];
  std::string lost = lost_contact(entry.value, {.asks = false}, methods_);
  if (!lost.empty()) return lost;
  const Result<CheckedCase> known = check_case(entry);
  if (!known) return known.error().message();
  for (const auto& [method, expected] : entry.value.expect) {
    if (!is_admitted(method)) continue;  // a plug-in
    const Outcome got = ask(methods_[method], *known, SearchOptions()).outcome;
    if (got == expected.outcome) continue;
    return fmt::format("{}: {}: expected {}, got {}", entry.id, method, name_of(expected.outcome),
                       name_of(got));
  }
  return "";
}

}  // namespace ccdfuzz
