#include <fmt/format.h>

#include "base/table.hpp"
#include "case/tree_file.hpp"
#include "certify/checker/check_truth.hpp"
#include "certify/oracle/complete_truth.hpp"
#include "cli/command.hpp"
#include "cli/common_options.hpp"
#include "cli/data_set.hpp"
#include "cli/interrupt.hpp"
#include "cli/output.hpp"
#include "cli/terminal.hpp"
#include "eval/stream_cases.hpp"

namespace ccdfuzz {

namespace {

struct ProveArguments {
  std::vector<std::string> files;
  std::string output;
  std::uint64_t max_pops = OracleOptions().max_pops;
  std::uint64_t max_nodes = OracleOptions().max_tree_nodes;
  int threads = 1;
  bool json = false;
};

std::string_view verdict_of(const Completed& completed) {
  const auto& collides = completed.value.truth.collides;
  return !collides ? "undecided" : *collides ? "hit" : "miss";
}

/// The certificate letters of a truth, as "WP" or "MT".
std::string certificates(const Truth& truth) {
  std::string letters;
  if (truth.witness) letters += 'W';
  if (truth.contact_box) letters += 'M';
  if (truth.contact_root) letters += 'R';
  if (truth.clearance) letters += proof_word(*truth.clearance);
  return letters;
}

nlohmann::ordered_json row_json(const std::string& id, const Completed& completed) {
  const Truth& truth = completed.value.truth;
  nlohmann::ordered_json row = {
      {"case", id}, {"verdict", verdict_of(completed)}, {"certificates", certificates(truth)}};
  row["contact_by"] = nullptr;
  if (const auto by = truth.contact_by()) row["contact_by"] = to_text(*by);
  row["clear_until"] = nullptr;
  if (truth.clear_until) row["clear_until"] = to_text(*truth.clear_until);
  row["tree_bytes"] = completed.tree.size();
  row["refuted"] = completed.refuted;
  if (!completed.note.empty()) row["note"] = completed.note;
  return row;
}

struct Counts {
  std::uint64_t hit = 0, miss = 0, undecided = 0, refuted = 0;

  void add(const Completed& completed) {
    const auto& collides = completed.value.truth.collides;
    ++(!collides ? undecided : *collides ? hit : miss);
    if (completed.refuted) ++refuted;
  }
};

Result<Completed> prove(const NamedCase& named, const OracleOptions& oracle) {
  // Of a certificate of absence complete_truth says whether it is refuted.
  if (auto checked = check_truth(named.value); !checked) {
    return input_error(named.id + ": " + checked.error().where, checked.error().what);
  }
  return complete_truth(named.value, trees_path(named.file), oracle);
}

Result<int> run_prove(const ProveArguments& options) {
  Result<DataSetWriter> destination = DataSetWriter::open(options.output);
  if (!destination) return tl::unexpected(destination.error());

  OracleOptions oracle;
  oracle.max_pops = options.max_pops;
  oracle.max_tree_nodes = options.max_nodes;
  Table table({{"case", Align::kLeft}, {"verdict", Align::kLeft}, {"why", Align::kLeft}});
  Counts counts;
  Progress progress;
  std::atomic<bool> stop = false;
  const std::atomic<bool>& interrupted = catch_interrupts();
  Result<void> written;
  std::uint64_t done = 0;
  const Result<void> read = stream_cases<NamedCase, Completed>(
      options.files, 1, options.threads,
      [&](const NamedCase& named, size_t) { return prove(named, oracle); },
      [&](const NamedCase& named, size_t, Completed completed, double share) {
        const std::string& id = named.id;
        ++done;
        counts.add(completed);
        if (options.json) {
          print_json(row_json(id, completed));
        } else if (completed.refuted || !completed.value.truth.collides) {
          table.add_row({{id},
                         {completed.refuted ? "refuted" : "undecided", Emphasis::kBad},
                         {completed.note}});
          print_full_rows(table);
        }
        if (written) written = destination->write(std::move(completed.value), completed.tree);
        if (!written || interrupted) stop = true;
        progress.show(share, id, done, "cases");
      },
      &stop);
  progress.clear();
  if (table.row_count() > 0) {
    print_last_rows(table);
    print_out("\n");
  }
  if (!read) return tl::unexpected(read.error());
  if (!written) return tl::unexpected(written.error());
  if (interrupted) return interrupted_exit_code();
  if (auto finished = destination->finish(); !finished) return tl::unexpected(finished.error());
  if (!options.json) {
    std::string summary = fmt::format("{} cases: {} hits, {} misses, {} undecided", done,
                                      counts.hit, counts.miss, counts.undecided);
    if (counts.refuted > 0) summary += fmt::format("; {} had claimed otherwise", counts.refuted);
    print_out(summary + "\n");
  }
  return counts.refuted == 0 ? kDone : kCheckFailed;
}

}  // namespace

void add_prove(CommandLine& line) {
  auto [command, options] = line.add<ProveArguments>(
      "prove", "Decide cases, and write them with certificates that verify checks", run_prove);
  command.texts("case", options->files, "Case files: .json, .jsonl or .jsonl.zst").required();
  command
      .text("-o,--output", options->output,
            "File to write: .jsonl, .jsonl.zst, or .json for one case; trees go beside it")
      .required();
  command.whole("--max-pops", options->max_pops,
                "Pairs of cells that one search may take before it gives up", 1);
  command.whole("--max-nodes", options->max_nodes, "Nodes that the tree of a miss may have", 1);
  add_threads(command, options->threads);
  command.flag("--json", options->json, "One JSON object per case");
}

}  // namespace ccdfuzz
