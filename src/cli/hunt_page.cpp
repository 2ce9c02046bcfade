#include "cli/hunt_page.hpp"

#include <fmt/format.h>

#include <set>

#include "cli/shell_word.hpp"
#include "corpus/entries.hpp"

namespace ccdfuzz {

namespace {

constexpr size_t kMostSamples = 400;

ReportedCase reported_find(const std::string& path, const Case& value, bool is_new) {
  ReportedCase reported;
  reported.id = path;
  reported.value = value;
  for (const auto& [method, outcome] : value.expect) {
    reported.answers.push_back({method, outcome, std::nullopt});
  }
  reported.is_new = is_new;
  reported.reproduce = reproduction(path, value.expect);
  return reported;
}

}  // namespace

void HuntSamples::note(double seconds, std::uint64_t queries, std::uint64_t finds) {
  if (seconds < next_) return;
  if (samples_.size() == kMostSamples) {
    // Half as many, for twice as long.
    for (size_t i = 0; 2 * i < samples_.size(); ++i) samples_[i] = samples_[2 * i];
    samples_.resize(kMostSamples / 2);
    step_ *= 2;
  }
  samples_.push_back({seconds, queries, finds});
  next_ = seconds + step_;
}

Result<ReportPage> hunt_page(const HuntReport& hunted, const std::string& store,
                             const std::vector<HuntSample>& samples) {
  ReportPage report;
  report.title = fmt::format("Hunt of {:.0f} s", hunted.seconds);
  report.samples = samples;
  for (const HuntCell& cell : hunted.cells) {
    ReportGroup group{
        std::string(name_of(cell.contact)), "", std::nullopt, cell.method, cell.tally, {}};
    group.tally.seconds = cell.cpu_seconds;
    report.groups.push_back(std::move(group));
  }
  std::set<std::string> found;
  for (const HuntFind& find : hunted.finds) {
    found.insert(find.path);
    report.cases.push_back(reported_find(find.path, find.value, true));
  }
  const Result<std::vector<std::string>> paths = list_entries(store);
  if (!paths) return tl::unexpected(paths.error());
  if (paths->size() > found.size()) {
    const Result<std::vector<NamedCase>> entries = load_corpus(store);
    if (!entries) return tl::unexpected(entries.error());
    for (const NamedCase& entry : *entries) {
      if (!found.contains(entry.id)) {
        report.cases.push_back(reported_find(entry.id, entry.value, false));
      }
    }
  }
  keep_most_telling(report);
  return report;
}

}  // namespace ccdfuzz
