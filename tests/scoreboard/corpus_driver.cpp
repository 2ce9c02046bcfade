#include "corpus_driver.hpp"

#include "certify/checker/check_case.hpp"
#include "finds/entries.hpp"
#include "finds/replay.hpp"
#include "method/ask.hpp"

namespace ccdfuzz {

CorpusDriver::CorpusDriver(const std::string& corpus) {
  Result<std::vector<NamedCase>> entries = load_corpus(corpus);
  if (!entries) {
    trouble_ = entries.error().message();
    entries_.resize(1);
    return;
  }
  // Those that were found at a precision of their own are not asked here.
  std::erase_if(*entries, [](const NamedCase& e) { return !(e.value.asked == Asked()); });
  entries_ = *std::move(entries);
}

std::string CorpusDriver::operator()(std::uint64_t index) {
  if (!trouble_.empty()) return trouble_;
  const NamedCase& entry = entries_[index];
  std::string lost = lost_contact(entry.value, {.asks = false}, tracers_);
  if (!lost.empty()) return lost;
  const Result<ReplayReport> report =
      replay({entry}, [&](const std::string& method, const NamedCase& named) -> Result<Judged> {
        return check_case(named).map([&](const CheckedCase& known) {
          return ask(methods_[method], known, SearchOptions());
        });
      });
  if (!report) return report.error().message();
  for (const ReplayRow& row : report->rows) {
    if (row.changed()) return to_text(row);
  }
  return "";
}

}  // namespace ccdfuzz
