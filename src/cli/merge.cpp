#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "cli/command.hpp"
#include "cli/common_options.hpp"
#include "cli/data_set.hpp"
#include "cli/session.hpp"
#include "eval/tables.hpp"
#include "finds/claim_files.hpp"
#include "finds/entries.hpp"
#include "finds/intake.hpp"
#include "io/input_bytes.hpp"
#include "io/output_file.hpp"
#include "io/run_file.hpp"
#include "method/plugin/plugin_spec.hpp"
#include "method/served_method.hpp"

namespace ccdfuzz {

namespace {

namespace fs = std::filesystem;

struct MergeOptions {
  std::vector<std::string> inputs;
  std::string output;
};

/// Calls visit on the record of each line. Returns how many there are.
template <class Record, class Visit>
std::uint64_t for_each_record(MergedRun& run, const Visit& visit) {
  for (std::uint64_t count = 0;; ++count) {
    const auto line = need(run.next());
    if (!line) return count;
    visit(*line, need(from_json<Record>(*line, run.where())));
  }
}

/// The data set of the shares of a `generate`.
int merge_made(const MergeOptions& options, Session& session) {
  refuse_input("--output", options.output, options.inputs, "shares");
  MergedRun run = need(MergedRun::open(options.inputs));
  if (run.header().run != "generate") {
    throw BadInput{{options.inputs[0], "is no share of a data set"}};
  }
  MadeSet set(options.output);
  for_each_record<MadeCases>(run, [&](std::string_view, const MadeCases& made) { set.add(made); });
  set.finish();
  set.show(session, fmt::format(" of {} files", options.inputs.size()));
  return kDone;
}

/// The folder of the shares of an `evaluate`.
int merge_evaluated(const MergeOptions& options, Session& session) {
  refuse_input("--output", options.output, options.inputs, "shares");
  std::vector<std::string> paths;
  for (const std::string& folder : options.inputs) paths.push_back(answers_path(folder));
  MergedRun run = need(MergedRun::open(paths));
  need(make_folder(options.output));
  OutputFile answers = need(OutputFile::create(answers_path(options.output)));
  need(answers.write(to_json(run.header()) + "\n"));
  Rows rows;
  const std::uint64_t cases =
      for_each_record<EvaluatedCase>(run, [&](std::string_view line, const EvaluatedCase& one) {
        rows.add(one);
        need(answers.write(std::string(line) + "\n"));
      });
  for (const std::string& file : run.header().inputs) {
    if (!fs::exists(file) && !fs::exists(costs_path(file))) {
      session.remark("{} is not there: Table 4 is without its costs", file);
    }
  }
  need(write_tables(options.output, rows, need(read_costs(run.header().inputs))));
  need(answers.commit());
  if (session.json) {
    for (const Row& row : by_kinds(rows)) print_row(row);
  }
  session.summary(fmt::format("the answers to {} cases of {} folders in {}", cases,
                              options.inputs.size(), options.output));
  return kDone;
}

int merge_corpora(const MergeOptions& options, Session& session) {
  const auto& [inputs, output] = options;
  Store store = need(Store::open(output));
  Intake intake(
      store, [] { return Asker({}); },
      [] { return Asker(limited({}), MethodSet(make_served_method)); });
  std::uint64_t entries = 0, taken = 0;
  std::vector<std::string> of_claims;
  for (const std::string& input : inputs) {
    const CorpusFiles files = need(cases_and_claims(input));
    of_claims.insert(of_claims.end(), files.claims.begin(), files.claims.end());
    if (files.cases.empty()) continue;
    need(for_each_entry(input, [&](const NamedCase& entry) {
      ++entries;
      if (need(intake.take(entry)) != Store::Put::kKnown) ++taken;
    }));
  }
  taken += need(intake.take_doubtful());
  const Intake::Settled& settled = intake.settled();
  const MergedClaims claims = need(merge_claims(of_claims, output, session.properties));
  const CorpusFiles now = need(cases_and_claims(output));
  if (session.json) {
    print_row([&](auto& row) {
      row("entries", entries);
      row("taken_over", taken);
      row("now", now.cases.size());
      row("asked_again", settled.asked);
      row.optional("not_asked", settled.kept);
      row.optional("claims", claims.entries);
      row.optional("claims_taken_over", claims.taken);
      row.optional("claims_now", now.claims.size());
      row.optional("claims_without_input", claims.without_input);
    });
  }
  session.summary(
      fmt::format("{} of {}, {} taken over, {} now in {}", counted(entries, "entry", "entries"),
                  counted(inputs.size(), "corpus", "corpora"), taken, now.cases.size(), output));
  if (claims.entries > 0) {
    session.summary(fmt::format(
        "{}, {} taken over, {} now in {}/{}{}",
        counted(claims.entries, "input of properties", "inputs of properties"), claims.taken,
        now.claims.size(), output, kClaims,
        claims.without_input == 0
            ? ""
            : fmt::format("; {} did not fail again and have no choices", claims.without_input)));
  }
  if (settled.asked > 0) {
    session.summary(
        fmt::format("{} expectations that two entries of a query left in doubt are now "
                    "what their methods show",
                    settled.asked));
  }
  for (const auto& [method, times] : settled.kept) {
    session.summary(
        fmt::format("{} expectations of {} in doubt are as the entry taken first says: "
                    "it cannot be asked{}",
                    times, method, names_plugin(method) ? " unless --plugin names it" : ""));
  }
  return kDone;
}

int run_merge(const MergeOptions& options, Session& session) {
  // Standard output takes the table.
  if (options.output == "-") throw BadInput{{"--output", "- is neither a file nor a folder"}};
  if (is_claims_folder(options.output)) {
    throw BadInput{{"--output", options.output + " is a folder of claims: name its corpus"}};
  }
  const auto is_folder = [](const std::string& path) { return fs::is_directory(path); };
  const auto folders = std::ranges::count_if(options.inputs, is_folder);
  if (folders == 0) return merge_made(options, session);
  if (static_cast<size_t>(folders) < options.inputs.size()) {
    const auto file = std::ranges::find_if_not(options.inputs, is_folder);
    throw BadInput{{*file, "is no folder, and others of the inputs are"}};
  }
  if (case_file_kind_by_name(options.output)) {
    throw BadInput{{"--output", options.output + " is a file of cases by its name: name a folder"}};
  }
  return fs::exists(answers_path(options.inputs[0])) ? merge_evaluated(options, session)
                                                     : merge_corpora(options, session);
}

}  // namespace

void add_merge(CommandLine& line) {
  auto [command, options] =
      line.add<MergeOptions>("merge", "Join the shares of a run, or corpora", run_merge);
  command.example("what two hunts found", "merge finds1 finds2 -o corpus");
  command
      .texts("input", options->inputs,
             "Shares of a data set (generate), or folders of answers (evaluate), or corpora (hunt) "
             "and folders of claims (check, triage)")
      .required();
  command
      .text("-o,--output PATH", options->output,
            "What to write: .jsonl or .jsonl.zst, or a folder; a corpus may be there already")
      .in("Results")
      .required();
  command.plugin_names();
  command.json("What the merged shares cost or answered, one JSON object per row");
  command.max_work();
}

}  // namespace ccdfuzz
