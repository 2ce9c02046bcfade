#include "cli/trace_generated.hpp"

#include <fmt/format.h>

#include <chrono>

#include "cli/command.hpp"
#include "cli/interrupt.hpp"
#include "cli/output.hpp"
#include "cli/reproduction.hpp"
#include "cli/terminal.hpp"
#include "cli/trace_row.hpp"
#include "query/case_files.hpp"
#include "query/shell_word.hpp"

namespace ccdfuzz {

namespace {

/// People are shown this many lost witnesses; all are counted, and in JSON and the file.
constexpr std::uint64_t kShown = 20;

std::string reproduction(const TraceCampaignOptions& options, const LostWitness& lost) {
  return fmt::format("trace --generate 1 --first {} --seed {} --methods {} --precision {}{}",
                     lost.number, options.seed, lost.method, options.trace.precision,
                     options.trace.all ? " --all" : "");
}

/// What is told of each lost witness, as it comes.
class Losses {
 public:
  static Result<Losses> open(const TraceCampaignOptions& options, const std::string& path,
                             bool json) {
    Losses out(options, json);
    if (!path.empty()) {
      Result<CaseWriter> writer = CaseWriter::open(path);
      if (!writer) return tl::unexpected(writer.error());
      out.writer_ = std::move(*writer);
    }
    return out;
  }

  void tell(const LostWitness& lost) {
    const std::string again = reproduction(*options_, lost);
    if (json_) {
      nlohmann::ordered_json row = {{"row", "lost"},
                                    {"number", lost.number},
                                    {"class", lost.value.origin.contact},
                                    {"generator", lost.value.origin.generator},
                                    {"breaks_claim", lost.breaks_claim},
                                    {"reproduce", shell_word(program_name()) + " " + again}};
      row.update(trace_row(fmt::format("{}", lost.number), lost.method, lost.trace));
      print_json(row);
    } else if (++told_ <= kShown) {
      print_out(fmt::format("lost: case {} ({} {}) by {}{}, level {}, axis {}\n  {} {}\n",
                            lost.number, lost.value.origin.contact, lost.value.origin.generator,
                            lost.method, lost.breaks_claim ? " (claims none)" : "",
                            lost.trace.loss->place.level, lost.trace.loss->by.axis,
                            shell_word(program_name()), again));
    }
    // A case that several methods lose comes from them one after the other.
    if (!writer_ || !written_ || last_ == lost.number) return;
    last_ = lost.number;
    Case value = lost.value;
    value.origin.note = "ccdfuzz " + again;
    written_ = writer_->write(value);
  }

  /// The file appears, if there is something in it.
  Result<void> finish() {
    if (!json_ && told_ > kShown) {
      print_out(fmt::format("… and {} more\n", told_ - kShown));
    }
    if (!json_ && told_ > 0) print_out("\n");
    if (!written_ || !writer_ || !last_) return written_;
    return writer_->finish();
  }

 private:
  Losses(const TraceCampaignOptions& options, bool json) : options_(&options), json_(json) {}

  const TraceCampaignOptions* options_;
  bool json_;
  std::optional<CaseWriter> writer_;
  Result<void> written_;
  std::optional<std::uint64_t> last_;
  std::uint64_t told_ = 0;
};

std::string each(const TraceCell& cell) {
  return cell.traced == 0 ? "-"
                          : duration_text(cell.cpu_seconds / static_cast<double>(cell.traced));
}

Table table_of(const TraceReport& report, size_t methods) {
  Table table({{"class", Align::kLeft},
               {"method", Align::kLeft},
               {"traced"},
               {"lost"},
               {"least margin"},
               {"least slack"},
               {"CPU time each"}});
  for (size_t i = 0; i < report.cells.size(); ++i) {
    const TraceCell& cell = report.cells[i];
    if (i % methods == 0) table.start_group();
    table.add_row({{std::string(name_of(cell.contact))},
                   {cell.method},
                   {fmt::format("{}", cell.traced)},
                   {cell.traced == 0 ? "0" : count_text(cell.lost, cell.traced),
                    cell.lost == 0 ? Emphasis::kPlain : Emphasis::kBad},
                   {cell.margin ? fmt::format("{}", *cell.margin) : ""},
                   {cell.slack ? fmt::format("{:.3g}", *cell.slack) : ""},
                   {each(cell)}});
  }
  return table;
}

void print_rows(const TraceReport& report) {
  for (const TraceCell& cell : report.cells) {
    nlohmann::ordered_json row = {{"row", "cell"},         {"class", name_of(cell.contact)},
                                  {"method", cell.method}, {"traced", cell.traced},
                                  {"lost", cell.lost},     {"margin", nullptr},
                                  {"slack", nullptr},      {"cpu_seconds", cell.cpu_seconds}};
    if (cell.margin) row["margin"] = *cell.margin;
    if (cell.slack) row["slack"] = *cell.slack;
    print_json(row);
  }
}

}  // namespace

Result<int> trace_generated_cases(const TraceCampaignOptions& options, const std::string& output,
                                  bool json) {
  const std::atomic<bool>& interrupted = catch_interrupts();
  Result<Losses> losses = Losses::open(options, output, json);
  if (!losses) return tl::unexpected(losses.error());
  Progress progress;
  const auto start = std::chrono::steady_clock::now();
  const TraceReport report = trace_generated(
      options,
      [&](const LostWitness& lost) {
        progress.clear();
        losses->tell(lost);
      },
      [&](std::uint64_t cases) {
        progress.show(static_cast<double>(cases) / static_cast<double>(options.count),
                      fmt::format("{} cases", cases), cases, "cases");
      },
      interrupted);
  progress.clear();
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  if (const Result<void> finished = losses->finish(); !finished) {
    return tl::unexpected(finished.error());
  }
  if (json) {
    print_rows(report);
    print_json({{"row", "summary"},
                {"seed", options.seed},
                {"first", options.first},
                {"cases", report.cases},
                {"traces", report.cases * options.methods.size()},
                {"lost", report.lost},
                {"broken_claims", report.broken_claims},
                {"seconds", seconds.count()}});
  } else {
    print_table(table_of(report, options.methods.size()));
    print_out(fmt::format(
        "\n{} cases from {} of seed {}, {} traces in {}: {} lost, {} by methods that claim none\n",
        report.cases, options.first, options.seed, report.cases * options.methods.size(),
        duration_text(seconds.count()), report.lost, report.broken_claims));
  }
  if (interrupted) return interrupted_exit_code();
  return report.broken_claims == 0 ? kDone : kCheckFailed;
}

}  // namespace ccdfuzz
