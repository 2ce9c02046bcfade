#include "cli/generate_paper.hpp"

#include <fmt/format.h>

#include <charconv>
#include <chrono>
#include <unordered_set>

#include "base/cpu_time.hpp"
#include "base/in_order.hpp"
#include "base/input_bytes.hpp"
#include "base/journal.hpp"
#include "base/verify.hpp"
#include "case/case_json.hpp"
#include "cli/command.hpp"
#include "cli/data_set.hpp"
#include "cli/interrupt.hpp"
#include "cli/output.hpp"
#include "cli/terminal.hpp"
#include "eval/generation_record.hpp"
#include "finds/content_address.hpp"
#include "generators/paper_set.hpp"

namespace ccdfuzz {

namespace {

/// A record of the journal: a line of numbers, a line a case, and the bytes of a tree.
struct PaperRecord {
  std::vector<Case> cases;
  std::string tree;
  DiscardCounts discards;
  double cpu_seconds = 0;
};

std::string bytes_of_record(const PaperRecord& record) {
  std::string bytes =
      fmt::format("{} {} {}", record.cases.size(), record.cpu_seconds, record.discards.attempts);
  for (const std::uint64_t count : record.discards.discarded) bytes += fmt::format(" {}", count);
  bytes += '\n';
  for (const Case& value : record.cases) bytes += to_json(value) + "\n";
  return bytes + record.tree;
}

/// The text up to the next end mark, which is taken away with it.
std::string_view take_text(std::string_view& from, char end) {
  const size_t at = from.find(end);
  CCDFUZZ_VERIFY(at != std::string_view::npos);  // the journal's hash says that we wrote it
  const std::string_view taken = from.substr(0, at);
  from.remove_prefix(at + 1);
  return taken;
}

template <class Number>
Number take_number(std::string_view& from, char end = ' ') {
  const std::string_view text = take_text(from, end);
  Number x{};
  CCDFUZZ_VERIFY(std::from_chars(text.data(), text.data() + text.size(), x).ec == std::errc());
  return x;
}

Result<PaperRecord> parse_paper_record(std::string_view bytes, const std::string& where) {
  PaperRecord record;
  const auto count = take_number<size_t>(bytes);
  record.cpu_seconds = take_number<double>(bytes);
  record.discards.attempts = take_number<std::uint64_t>(bytes);
  for (std::uint64_t& n : record.discards.discarded) {
    const bool last = &n == &record.discards.discarded.back();
    n = take_number<std::uint64_t>(bytes, last ? '\n' : ' ');
  }
  for (size_t i = 0; i < count; ++i) {
    Result<Case> value = parse_case(take_text(bytes, '\n'), where);
    if (!value) return tl::unexpected(value.error());
    record.cases.push_back(*std::move(value));
  }
  record.tree = bytes;
  return record;
}

GenerationCost cost_of_item(const PaperItem& item, const PaperRecord& record) {
  GenerationCost cost;
  cost.contact = name_of(item.contact);
  cost.kind = item.kind == CaseKind::kRP ? "RP+RN" : name_of(item.kind);
  cost.cases = record.cases.size();
  cost.begun = record.discards.attempts;
  for (const Discard reason : kDiscards) {
    cost.discarded.emplace_back(name_of(reason), record.discards[reason]);
  }
  cost.cpu_seconds = record.cpu_seconds;
  return cost;
}

struct PaperTotals {
  std::vector<GenerationCost> costs;
  std::uint64_t cases = 0;
  std::uint64_t duplicates = 0;
  std::uint64_t trees = 0;
};

/// Puts the data set together from the journal.
Result<PaperTotals> write_paper_set(const Journal& journal, const std::vector<PaperItem>& items,
                                    const GeneratePaperOptions& options) {
  auto writer = DataSetWriter::open(options.output);
  if (!writer) return tl::unexpected(writer.error());
  PaperTotals totals;
  std::unordered_set<std::string> addresses;
  size_t next = 0;
  auto done = journal.for_each([&](std::string_view bytes) -> Result<void> {
    Result<PaperRecord> record = parse_paper_record(bytes, Journal::path_for(options.output));
    if (!record) return tl::unexpected(record.error());
    const PaperItem& item = items[options.shard.item(next++)];
    merge_costs(totals.costs, {cost_of_item(item, *record)});
    for (Case& value : record->cases) {
      ++totals.cases;
      if (!addresses.insert(content_address(value.query)).second) ++totals.duplicates;
      if (!record->tree.empty()) {
        value.truth.clearance = MissTree{exact(value.query.t_max), {}};
        value.truth.proof = proof_word(*value.truth.clearance);
        ++totals.trees;
      }
      if (auto written = writer->write(std::move(value), record->tree); !written) return written;
    }
    return {};
  });
  const GenerationRecord record = {
      fmt::format("paper, seed {}, one in {}", options.seed, options.one_in), options.shard,
      totals.costs};
  done = done.and_then([&] { return write_generation(generation_path(options.output), record); })
             .and_then([&] { return writer->finish(); });
  if (!done) return tl::unexpected(done.error());
  return totals;
}

void print_paper_totals(const PaperTotals& totals, const GeneratePaperOptions& options,
                        double seconds) {
  double cpu_seconds = 0;
  for (const GenerationCost& cost : totals.costs) cpu_seconds += cost.cpu_seconds;
  if (options.json) {
    for (const GenerationCost& cost : totals.costs) print_out(to_json(cost) + "\n");
    return;
  }
  print_table(generation_table(totals.costs));
  print_out(fmt::format(
      "\n{} cases in {}, {} duplicates, {} miss trees; {} in this run, {} of CPU time in all\n",
      totals.cases, options.output, totals.duplicates, totals.trees, duration_text(seconds),
      duration_text(cpu_seconds)));
}

Journal::Header paper_header(const GeneratePaperOptions& options) {
  return {{"run", "generate --paper"},
          {"ccdfuzz", CCDFUZZ_VERSION},
          {"--seed", fmt::format("{}", options.seed)},
          {"--one-in", fmt::format("{}", options.one_in)},
          {"--shard", fmt::format("{}/{}", options.shard.index, options.shard.of)}};
}

}  // namespace

Result<int> generate_paper(const GeneratePaperOptions& options) {
  const std::vector<PaperItem> items = paper_items(options.one_in);
  const auto kind = case_file_kind(options.output);
  if (!kind) return tl::unexpected(kind.error());
  if (*kind == CaseFileKind::kJson) {
    return input_error(options.output, "a .json file holds one case; .jsonl holds many");
  }
  // Whether the result can be written is to be known before the work is done.
  if (auto trial = DataSetWriter::open(options.output); !trial) {
    return tl::unexpected(trial.error());
  }
  const std::atomic<bool>& interrupted = catch_interrupts();
  Result<Journal> journal = Journal::open(Journal::path_for(options.output), paper_header(options));
  if (!journal) return tl::unexpected(journal.error());

  const std::uint64_t total = options.shard.size(items.size());
  const std::uint64_t before = journal->size();
  if (before > 0) {
    print_err(fmt::format("ccdfuzz: going on behind {} of {} constructions in {}\n", before, total,
                          Journal::path_for(options.output)));
  }
  std::atomic<bool> stop = false;
  Result<void> kept;
  Progress progress;
  const auto start = std::chrono::steady_clock::now();
  run_in_order<std::string>(
      total - before, options.threads,
      [&](size_t i) {
        const PaperItem& item = items[options.shard.item(before + i)];
        const double begin = thread_cpu_seconds();
        PaperCases made = make_paper_cases(item, options.seed);
        return bytes_of_record({std::move(made.cases), std::move(made.tree), made.discards,
                                thread_cpu_seconds() - begin});
      },
      [&](const std::string& record) {
        if (kept) kept = journal->append(record);
        if (!kept || interrupted) stop = true;
        const PaperItem& item = items[options.shard.item(journal->size() - 1)];
        progress.show(static_cast<double>(journal->size()) / static_cast<double>(total),
                      fmt::format("{} {}", name_of(item.contact), name_of(item.kind)),
                      journal->size() - before, "constructions");
      },
      &stop);
  progress.clear();
  if (!kept) return tl::unexpected(kept.error());
  if (journal->size() < total) {
    print_err(
        fmt::format("ccdfuzz: interrupted after {} of {} constructions; the same command goes "
                    "on from there\n",
                    journal->size(), total));
    return interrupted_exit_code();
  }
  const Result<PaperTotals> totals = write_paper_set(*journal, items, options);
  if (!totals) return tl::unexpected(totals.error());
  if (auto removed = journal->remove(); !removed) return tl::unexpected(removed.error());
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
  print_paper_totals(*totals, options, elapsed.count());
  CCDFUZZ_VERIFY(totals->duplicates == 0);
  return kDone;
}

}  // namespace ccdfuzz
