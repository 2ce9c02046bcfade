#include "finds/replay.hpp"

#include <fmt/format.h>
#include <tbb/enumerable_thread_specific.h>

#include <algorithm>
#include <map>

#include "base/in_order.hpp"
#include "base/number_text.hpp"
#include "base/table.hpp"
#include "case/tree_file.hpp"
#include "certify/checker/check_case.hpp"
#include "certify/checker/run_work.hpp"
#include "cli/answer_row.hpp"
#include "cli/command.hpp"
#include "cli/common_options.hpp"
#include "cli/output.hpp"
#include "cli/terminal.hpp"
#include "finds/entries.hpp"
#include "method/plugin/plugin_spec.hpp"
#include "method/served_method.hpp"

namespace ccdfuzz {

namespace {

struct ReplayArguments {
  std::string corpus = "corpus";
  AllowedPlugins plugins;
  SearchFlags search;
  int threads = 1;
  bool json = false;
};

struct Question {
  const NamedCase* entry;
  const CheckedCase* known;
  std::string method;
  Outcome expected;
  SearchOptions search;
};

/// Takes the expectations of plug-ins that are not allowed out of the entries.
NotAllowed leave_out_plugins(std::vector<NamedCase>& entries, bool json) {
  NotAllowed left_out;
  for (NamedCase& entry : entries) {
    std::erase_if(entry.value.expect, [&](const auto& expectation) {
      const auto& [method, expected] = expectation;
      if (is_admitted(method)) return false;
      ++left_out[method];
      if (json) {
        print_json({{"case", entry.id},
                    {"method", method},
                    {"outcome", "not_asked"},
                    {"expected", name_of(expected.outcome)}});
      }
      return true;
    });
  }
  return left_out;
}

/// What the checker refutes; of the entries that stay, their checked cases, in their order.
struct Checked {
  std::vector<CheckedCase> known;
  std::vector<InputError> refuted;
};

/// Errors: as RunWork::add.
Result<Checked> check_entries(std::vector<NamedCase>& entries, int threads) {
  struct Entry {
    Result<CheckedCase> checked;
    std::uint64_t work;
  };
  Checked out;
  Result<void> within;
  std::atomic<bool> ended = false;
  std::vector<NamedCase> holding;
  size_t done = 0;
  run_in_order<Entry>(
      entries.size(), threads,
      [&](size_t i) -> Entry {
        const std::uint64_t before = work_done_here();
        auto checked = check_case(entries[i].value, trees_path(entries[i].file));
        return {std::move(checked), work_done_here() - before};
      },
      [&](Entry checked_entry) {
        auto& [checked, work] = checked_entry;
        NamedCase& entry = entries[done++];
        if (within) within = RunWork::add(entry, work);
        if (!within) {
          ended = true;
        } else if (!checked) {
          out.refuted.push_back({entry.id, checked.error().message()});
        } else {
          out.known.push_back(*std::move(checked));
          holding.push_back(std::move(entry));
        }
      },
      &ended);
  if (!within) return tl::unexpected(within.error());
  entries = std::move(holding);
  return out;
}

void print_refuted(const std::vector<InputError>& refuted, bool json) {
  for (const InputError& error : refuted) {
    if (json) {
      print_json({{"case", error.where}, {"truth", "refuted"}, {"note", error.what}});
    } else {
      print_out(fmt::format("refuted: {}\n", error.message()));
    }
  }
}

Result<std::vector<Question>> questions_of(const std::vector<NamedCase>& entries,
                                           const std::vector<CheckedCase>& known,
                                           const SearchFlags& flags) {
  std::vector<Question> questions;
  for (size_t i = 0; i < entries.size(); ++i) {
    const NamedCase& entry = entries[i];
    const SearchOptions own = flags.options_for(entry.value);
    for (const auto& [method, expected] : entry.value.expect) {
      if (const auto made = make_method(method); !made) {
        return input_error(entry.id + ": expect", made.error().what);
      }
      questions.push_back({&entry, &known[i], method, expected.outcome, own});
    }
  }
  return questions;
}

/// An entry may be there for a crash or a hang of a method that runs in this process.
bool may_end_its_process(const Question& question) {
  return question.expected == Outcome::kError && !names_plugin(question.method);
}

/// An answer and what was expected, as a row of the JSON output.
struct ReplayJson {
  const ReplayRow& row;

  static void fields(auto& archive, auto& json) {
    const AnswerRow answer(json.row.id, json.row.method, json.row.got);
    AnswerRow::fields(archive, answer);
    archive("expected", json.row.expected);
  }
};

void print_report(const ReplayReport& report) {
  Table table({{"entry", Align::kLeft},
               {"method", Align::kLeft},
               {"expected", Align::kLeft},
               {"got", Align::kLeft}});
  for (const ReplayRow& row : report.rows) {
    if (!row.changed()) continue;
    table.add_row({{row.id},
                   {row.method},
                   {std::string(name_of(row.expected))},
                   {std::string(name_of(row.got.outcome)), Emphasis::kBad}});
  }
  if (table.row_count() > 0) {
    print_table(table);
    print_out("\n");
  }
  print_out(fmt::format("{} entries, {} expectations: {} as expected, {} changed\n", report.entries,
                        report.rows.size(), report.rows.size() - report.changed(),
                        report.changed()));
}

Result<int> run_replay(const ReplayArguments& options) {
  if (const auto admitted = options.plugins.admit(); !admitted) {
    return tl::unexpected(admitted.error());
  }
  Result<std::vector<NamedCase>> entries = load_unchecked_corpus(options.corpus);
  if (!entries) return tl::unexpected(entries.error());
  const Result<Checked> checked = check_entries(*entries, options.threads);
  if (!checked) return tl::unexpected(checked.error());
  print_refuted(checked->refuted, options.json);
  if (entries->empty()) return kCheckFailed;
  const NotAllowed left_out = leave_out_plugins(*entries, options.json);
  Result<std::vector<Question>> questions = questions_of(*entries, checked->known, options.search);
  if (!questions) return tl::unexpected(questions.error());

  std::map<std::pair<const Case*, std::string>, Judged> answers;
  Progress progress;
  const auto note = [&](const Question& q, Judged judged) {
    progress.show(static_cast<double>(answers.size()) / static_cast<double>(questions->size()),
                  q.entry->id, answers.size(), "answers");
    answers.emplace(std::pair(&q.entry->value, q.method), std::move(judged));
  };
  tbb::enumerable_thread_specific<MethodSet> methods,
      served([] { return MethodSet(make_served_method); });
  run_in_order<Judged>(
      questions->size(), options.threads,
      [&](size_t i) {
        const Question& q = (*questions)[i];
        MethodSet& asked = may_end_its_process(q) ? served.local() : methods.local();
        return ask(asked[q.method], *q.known, q.search);
      },
      [&](Judged judged) { note((*questions)[answers.size()], std::move(judged)); });
  progress.clear();
  const Result<ReplayReport> report =
      replay(*entries, [&](const std::string& method, const NamedCase& entry) -> Result<Judged> {
        return answers.at({&entry.value, method});
      });
  if (!report) return tl::unexpected(report.error());
  if (options.json) {
    for (const ReplayRow& row : report->rows) print_row(ReplayJson{row});
  } else {
    print_report(*report);
  }
  if (!left_out.empty()) print_err(fmt::format("ccdfuzz: replay: {}\n", to_text(left_out)));
  note_words(*entries, "replay");
  return report->changed() == 0 && checked->refuted.empty() ? kDone : kCheckFailed;
}

}  // namespace

void add_replay(CommandLine& line) {
  auto [command, options] = line.add<ReplayArguments>(
      "replay", "Judge every entry of a corpus again, against its expectations", run_replay);
  command.text("corpus", options->corpus, "Folder, or a file of cases");
  options->plugins.add_to(command);
  options->search.add_to(command);
  command.threads(options->threads);
  command.flag("--json", options->json, "One JSON object per expectation");
  command.max_work();
}

}  // namespace ccdfuzz
