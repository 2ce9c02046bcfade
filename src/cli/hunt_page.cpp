#include "cli/hunt_page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <set>

#include "base/text.hpp"
#include "cli/common_options.hpp"
#include "cli/interrupt.hpp"
#include "eval/tables.hpp"
#include "files/check_file.hpp"
#include "files/engine_test.hpp"
#include "finds/failure.hpp"
#include "method/plugin/plugin_spec.hpp"

namespace ccdfuzz {

namespace {

/// An argument that is a path, also one that begins as options do.
std::string path_word(const std::string& path) {
  return shell_word((path.starts_with('-') ? "./" : "") + path);
}

/// How many mutants each method was asked about, or traced, and how many of them its tests lost, if
/// any is traced.
void add_mutant_columns(std::vector<Column<HuntCell>>& columns,
                        const std::vector<HuntCell>& cells) {
  columns.push_back({{"mutants"}, [](const HuntCell& cell) {
                       return TableCell{fmt::format("{}", cell.bred.mutants)};
                     }});
  if (!any_is_traced(cells)) return;
  columns.push_back({{"lost"}, [](const HuntCell& cell) {
                       return names_plugin(cell.method)
                                  ? TableCell{"-"}
                                  : count_cell(cell.bred.lost, cell.bred.mutants, true);
                     }});
}

/// A cell for each method, over all classes.
std::vector<HuntCell> by_method(const std::vector<HuntCell>& cells) {
  std::vector<HuntCell> sums;
  for (const HuntCell& cell : cells) {
    const auto sum = std::ranges::find(sums, cell.method, &HuntCell::method);
    if (sum == sums.end()) {
      sums.push_back(cell);
      continue;
    }
    sum->tally.merge(cell.tally);
    sum->beside.merge(cell.beside);
    sum->bred.mutants += cell.bred.mutants;
    sum->bred.lost += cell.bred.lost;
    const auto& margin = cell.bred.margin;
    if (margin) sum->bred.margin = std::min(*margin, sum->bred.margin.value_or(*margin));
  }
  return sums;
}

}  // namespace

std::string reproduction(const std::string& path, const std::map<std::string, Expected>& expect) {
  std::vector<std::string> methods;
  for (const auto& [method, expected] : expect) {
    if (is_failure(expected.outcome)) methods.push_back(method);
  }
  return fmt::format("{} query {}{}", shell_word(program_name()), path_word(path),
                     method_words(methods));
}

std::optional<std::string> export_command(const Find& find) {
  for (const EngineTemplate& of : engine_templates()) {
    if (find.failure.who != fmt::format("plugin:{}", of.engine)) continue;
    if (!engine_test({find.path, find.value}, of.engine, TestPart::kQuestion)) return std::nullopt;
    const std::string test = std::filesystem::path(find.path).stem().string();
    return fmt::format("{} export {} --as {} -o {}{}", shell_word(program_name()),
                       path_word(find.path), of.engine, shell_word(test), of.ending);
  }
  return std::nullopt;
}

std::string replay_command(const std::string& folder, std::vector<std::string> methods) {
  const std::string names = plugin_words(methods);
  std::erase_if(methods, [](const std::string& method) {
    return !names_plugin(method) || !spec_behind(method).empty();
  });
  return fmt::format("{} replay {}{}{}", shell_word(program_name()), path_word(folder), names,
                     option_words("--allow-plugins", methods));
}

Result<ReportedCase> reported_entry(const NamedCase& entry, MethodSet& methods) {
  CCDFUZZ_TRY(const CheckedCase known, check_case(entry));
  const SearchOptions search = SearchFlags().options_for(entry.value);
  ReportedCase reported;
  for (const auto& [method, expected] : entry.value.expect) {
    const Outcome outcome = expected.outcome;
    const bool allowed = is_admitted(method);
    if (allowed) {
      if (const auto made = make_method(method); !made) {
        return input_error(entry.id + ": expect", made.error().what);
      }
    }
    GivenAnswer answer;
    answer.method = method;
    answer.outcome = outcome;
    const bool is_hit = outcome == Outcome::kLate || outcome == Outcome::kFalsePositive;
    if (allowed && is_hit && !catch_interrupts()) {
      const Judged judged = ask(methods[method], known, search);
      if (judged.answer.verdict == Verdict::kHit) answer.toi = judged.answer.toi;
    }
    reported.answers.push_back(std::move(answer));
  }
  reported.id = entry.id;
  reported.precision = search.precision;
  reported.reproduce = reproduction(entry.id, entry.value.expect);
  reported.value = entry.value;
  return reported;
}

bool any_is_traced(const std::vector<HuntCell>& cells) {
  return std::ranges::any_of(cells, [](const HuntCell& cell) {
    return !names_plugin(cell.method) && (cell.bred.lost > 0 || cell.bred.margin);
  });
}

Table hunt_table(const std::vector<HuntCell>& of_classes, bool by_class) {
  const std::vector<HuntCell> cells = by_class ? of_classes : by_method(of_classes);
  std::vector<Column<HuntCell>> columns;
  if (by_class) {
    columns.push_back(
        text_column<HuntCell>("class", [](const HuntCell& cell) { return name_of(cell.contact); }));
  }
  columns.push_back(
      text_column<HuntCell>("method", [](const HuntCell& cell) { return marked(cell.method); }));
  columns.back().most_width = method_column().most_width;
  columns.push_back(
      {{"drawn"}, [](const HuntCell& cell) { return TableCell{fmt::format("{}", cell.tally.n)}; }});
  add_outcomes(columns, {Outcome::kMissed, Outcome::kLate, Outcome::kUndecided}, false);
  add_outcomes(columns,
               met_in(cells, {Outcome::kError, Outcome::kFalsePositive, Outcome::kUnknown}), false);
  add_refused_column(columns, cells);
  columns.push_back(time_column<HuntCell>("mean", &LogHistogram::mean, false));
  if (std::ranges::any_of(cells, [](const HuntCell& cell) { return cell.beside.count() > 0; })) {
    columns.push_back({{"beside", Align::kRight, kTimeWidth}, [](const HuntCell& cell) {
                         const bool is_timed = cell.beside.count() > 0;
                         return TableCell{is_timed ? duration_text(cell.beside.mean()) : "-"};
                       }});
  }
  add_mutant_columns(columns, cells);
  return table_of(cells, columns, [by_class](const HuntCell& a, const HuntCell& b) {
    return !by_class || a.contact == b.contact;
  });
}

Result<ReportPage> hunt_page(const HuntReport& hunted, const std::vector<std::string>& asked,
                             Store& store) {
  ReportPage report;
  report.title = fmt::format("Hunt of {:.0f} s", hunted.seconds);
  report.command = command_line();
  report.hunted = asked;
  report.course = hunted.course;
  for (const HuntCell& cell : hunted.cells) {
    Row row{{std::string(name_of(cell.contact)), "", std::nullopt, cell.method}, cell.tally};
    row.tally.seconds = {};  // a hunt is no measurement of times
    report.rows.push_back(std::move(row));
  }
  std::string what = "What the hunt asked, bred and lost\n" + mark_note(asked);
  what.pop_back();
  report.tables.push_back({"hunt", what, hunt_table(hunted.cells, true)});
  CCDFUZZ_TRY(const std::vector<NamedCase> entries, store.load());
  std::set<std::string> found;
  for (const Find& find : hunted.finds) {
    if (find.is_new) found.insert(find.path);
  }
  MethodSet methods;
  for (const bool is_new : {true, false}) {
    for (const NamedCase& entry : entries) {
      if (found.contains(entry.id) != is_new) continue;
      CCDFUZZ_TRY(ReportedCase reported, reported_entry(entry, methods));
      reported.is_new = is_new;
      report.cases.push_back(std::move(reported));
    }
  }
  keep_most_telling(report);
  return report;
}

}  // namespace ccdfuzz
