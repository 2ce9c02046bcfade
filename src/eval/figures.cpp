#include "eval/figures.hpp"

#include <fmt/format.h>

#include <cmath>
#include <map>

#include "eval/curvature.hpp"
#include "eval/table.hpp"

namespace ccdfuzz {

namespace {

constexpr int kLinearBins = 50, kBinsADecade = 10;

/// Bin number → count.
using Bins = std::map<int, std::uint64_t>;

std::string bins_csv(const EvaluatedGroup& group, const char* scale, const Bins& bins,
                     const auto& edge) {
  std::string lines;
  for (const auto& [bin, count] : bins) {
    lines += fmt::format("{},{},{},{},{},{}\n", csv_field(group.contact), csv_field(group.method),
                         scale, edge(bin), edge(bin + 1), count);
  }
  return lines;
}

}  // namespace

std::string figure_5_header() {
  return "index,case,class,kind,patch,kappa_1,kappa_2,rms\n";
}

std::string figure_5_lines(const std::vector<NamedCase>& cases, const Shard& shard) {
  std::string lines;
  for (std::uint64_t k = 0; k < shard.size(cases.size()); ++k) {
    const std::uint64_t index = shard.item(k);
    const Case& value = cases[index].value;
    const auto both = curvature_at_contact(value);
    if (!both) continue;
    for (size_t s = 0; s < 2; ++s) {
      const auto& curvature = (*both)[s];
      if (!curvature) continue;
      lines += fmt::format("{},{},{},{},{},{},{},{}\n", index, csv_field(cases[index].id),
                           csv_field(value.origin.contact), csv_field(value.origin.kind), s + 1,
                           curvature->kappa[0], curvature->kappa[1], curvature->rms());
    }
  }
  return lines;
}

std::string figure_8_csv(const std::vector<EvaluatedGroup>& groups) {
  std::string lines = "class,method,positives,missed,late,missed_rate,mean_ms,median_ms,p99_ms\n";
  for (const EvaluatedGroup& group : at_contact(groups, std::nullopt)) {
    const Tally& tally = group.tally;
    if (tally.n == 0) continue;  // all refused
    const std::uint64_t missed = tally.count(Outcome::kMissed);
    lines += fmt::format(
        "{},{},{},{},{},{},{},{},{}\n", csv_field(group.contact), csv_field(group.method),
        tally.positives, missed, tally.count(Outcome::kLate),
        tally.positives == 0
            ? ""
            : fmt::format("{}", static_cast<double>(missed) / static_cast<double>(tally.positives)),
        tally.mean_seconds() * 1e3, group.seconds.median() * 1e3, group.seconds.p99() * 1e3);
  }
  return lines;
}

std::string figure_9_csv(const std::vector<EvaluatedGroup>& groups) {
  std::string lines = "class,method,scale,from_ms,to_ms,count\n";
  for (const EvaluatedGroup& group : at_contact(groups, std::nullopt)) {
    const double width = group.seconds.largest() / kLinearBins;
    Bins linear, log;
    for (const double seconds : group.seconds.all()) {
      if (width > 0) {
        const auto bin = static_cast<int>(seconds / width);
        ++linear[std::min(bin, kLinearBins - 1)];
      }
      // A clock may see no time at all: nanoseconds are as fine as it gets.
      ++log[static_cast<int>(std::floor(kBinsADecade * std::log10(std::max(seconds, 1e-9))))];
    }
    lines += bins_csv(group, "linear", linear, [&](int bin) { return bin * width * 1e3; });
    lines += bins_csv(group, "log", log, [](int bin) {
      return std::pow(10.0, static_cast<double>(bin) / kBinsADecade + 3);
    });
  }
  return lines;
}

}  // namespace ccdfuzz
