#include "report/report.hpp"

#include <fmt/format.h>

#include <map>

#include "io/output_file.hpp"

namespace ccdfuzz {

namespace {

/// Class, kind and how each method did: what cases of one sort have in common.
std::string sort_of(const ReportedCase& reported) {
  std::string key = reported.value.origin.contact + " " + reported.value.origin.kind;
  for (const GivenAnswer& answer : reported.answers) {
    key += fmt::format(" {}={}", answer.method, name_of(answer.outcome));
  }
  return key;
}

}  // namespace

void keep_most_telling(ReportPage& report, std::size_t most) {
  if (report.cases.size() <= most) return;
  // Turn by turn: the n-th case of every sort before the (n+1)-th of any.
  std::map<std::string, std::size_t> seen;
  std::vector<std::pair<std::size_t, std::size_t>> order;  // turn, place
  for (std::size_t i = 0; i < report.cases.size(); ++i) {
    order.emplace_back(seen[sort_of(report.cases[i])]++, i);
  }
  std::ranges::sort(order);
  order.resize(most);
  std::ranges::sort(order, {}, &std::pair<std::size_t, std::size_t>::second);
  std::vector<ReportedCase> kept;
  kept.reserve(most);
  for (const auto& [turn, place] : order) kept.push_back(std::move(report.cases[place]));
  report.cases_left_out += report.cases.size() - most;
  report.cases = std::move(kept);
}

Result<void> write_report(ReportPage report, const std::string& folder, int threads,
                          std::size_t most_bytes) {
  CCDFUZZ_TRY_VOID(make_folder(folder));
  std::string page = report_page(report, threads);
  while (page.size() > most_bytes && !report.cases.empty()) {
    // Cases are most of what a page can have too much of; the tenth is for those that are larger.
    const double share = 0.9 * static_cast<double>(most_bytes) / static_cast<double>(page.size());
    keep_most_telling(report,
                      static_cast<std::size_t>(share * static_cast<double>(report.cases.size())));
    page = report_page(report, threads);
  }
  return write_file(folder + "/index.html", page);
}

}  // namespace ccdfuzz
