#include <fmt/format.h>

#include <map>

#include "certify/checker/check_truth.hpp"
#include "certify/oracle/complete_truth.hpp"
#include "cli/command.hpp"
#include "cli/common_options.hpp"
#include "cli/data_set.hpp"
#include "cli/session.hpp"

namespace ccdfuzz {

namespace {

struct ProveOptions {
  std::vector<std::string> files;
  std::string output;
  OracleOptions oracle;
};

std::string_view verdict_of(const Completed& completed) {
  const auto& collides = completed.value.truth.collides;
  return !collides ? "undecided" : *collides ? "hit" : "miss";
}

/// The certificate letters of a truth, as "WP" or "MT".
std::string certificates_of(const Truth& truth) {
  std::string letters;
  if (truth.witness) letters += 'W';
  if (truth.contact_box) letters += 'M';
  if (truth.contact_root) letters += 'R';
  if (truth.clearance) letters += proof_word(*truth.clearance);
  return letters;
}

size_t tree_bytes_of(const Truth& truth) {
  const auto* const tree = clearance_of<MissTree>(truth);
  return tree == nullptr ? 0 : tree->tree.bytes.size();
}

void show(const std::string& id, const Completed& completed, Session& session) {
  const Truth& truth = completed.value.truth;
  const auto text_of = [](const std::optional<Rational>& time) {
    return time ? std::optional(to_text(*time)) : std::nullopt;
  };
  session.show(
      [&](auto& row) {
        row("case", id);
        row("verdict", verdict_of(completed));
        row("certificates", certificates_of(truth));
        row("contact_by", text_of(truth.contact_by()));
        row("clear_until", text_of(truth.clear_until));
        row("tree_bytes", tree_bytes_of(truth));
        row("refuted", completed.refuted);
        row.optional("note", completed.note);
      },
      [&]() -> std::vector<TableCell> {
        return {{id}, {completed.refuted ? "refuted" : "undecided", true}, {completed.note}};
      });
}

/// Throws BadInput: what the case says of a contact is refuted.
Completed prove(const NamedCase& named, const OracleOptions& oracle) {
  // complete_truth says whether a certificate of absence is refuted.
  if (auto checked = check_truth(named.value); !checked) {
    throw BadInput{{named.id + ": " + checked.error().where, checked.error().what}};
  }
  return complete_truth(named.value, oracle);
}

int run_prove(const ProveOptions& options, Session& session) {
  MadeSet set(options.output);
  session.begin_table({{"case", Align::kLeft}, {"verdict", Align::kLeft}, {"why", Align::kLeft}});
  std::map<std::string_view, std::uint64_t> counts;  // by verdict
  std::uint64_t refuted = 0;
  session.each_case<Completed>(
      CaseStream(options.files),
      [&](const NamedCase& named) { return prove(named, options.oracle); },
      [&](const NamedCase& named, Completed completed) {
        ++counts[verdict_of(completed)];
        if (completed.refuted) ++refuted;
        if (session.json || completed.refuted || !completed.value.truth.collides) {
          show(named.id, completed, session);
        }
        need(set.writer.write(completed.value));
      });
  session.end_table(true);
  if (session.interrupted()) {
    return session.end_unwritten(session.counts.cases, "cases", options.output);
  }
  set.costs = need(read_costs(options.files));
  set.finish();
  std::string summary =
      fmt::format("{}: {}, {}, {} undecided", counted(session.counts.cases, "case", "cases"),
                  counted(counts["hit"], "hit", "hits"), counted(counts["miss"], "miss", "misses"),
                  counts["undecided"]);
  if (refuted > 0) summary += fmt::format("; {} had claimed otherwise", refuted);
  session.summary(summary);
  return refuted == 0 ? kDone : kCheckFailed;
}

}  // namespace

void add_prove(CommandLine& line) {
  auto [command, options] = line.add<ProveOptions>(
      "prove", "Decide cases exactly, and add certificates that verify checks", run_prove);
  command.example("your own cases", "prove mine.jsonl -o proven.jsonl");
  command.texts("case", options->files, "Case files: .json, .jsonl, .jsonl.zst or .csv").required();
  command
      .text("-o,--output FILE", options->output,
            "File to write: .jsonl, .jsonl.zst, or .json for one case")
      .in("Results")
      .required();
  command.json("One JSON object per case");
  command.group("Limits");
  command.whole("--max-pops", options->oracle.max_pops,
                "Pairs of cells that one search may take before it gives up", 1);
  command.whole("--max-nodes", options->oracle.max_tree_nodes,
                "Nodes that the tree of a miss may have", 1);
  command.max_work();
  command.threads();
}

}  // namespace ccdfuzz
