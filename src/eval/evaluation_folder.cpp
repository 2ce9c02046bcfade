#include "eval/evaluation_folder.hpp"

#include <fmt/format.h>

#include "base/fields.hpp"
#include "base/output_file.hpp"
#include "eval/paper_tables.hpp"

namespace ccdfuzz {

std::string answers_path(const std::string& folder) {
  return folder + "/answers.jsonl";
}

std::vector<NamedTable> evaluation_tables(const std::vector<EvaluatedGroup>& groups,
                                          const std::vector<GenerationCost>& costs) {
  std::vector<NamedTable> tables = {{"Performance", performance_table(groups)}};
  const auto add = [&](const char* title, Table table) {
    if (table.row_count() > 0) tables.push_back({title, std::move(table)});
  };
  add("Table 1, beside the paper's", paper_table(compare_with_table_1(groups)));
  add("Table 2, beside the paper's", paper_table(compare_with_table_2(groups)));
  add("Table 4: making the cases, beside the paper's", generation_table(costs));
  return tables;
}

Result<void> write_tables(const std::string& folder, const std::vector<EvaluatedGroup>& groups,
                          const std::vector<GenerationCost>& costs) {
  std::string markdown, rows;
  for (const auto& [title, table] : evaluation_tables(groups, costs)) {
    markdown +=
        fmt::format("{}## {}\n\n{}", markdown.empty() ? "" : "\n", title, table.to_markdown());
  }
  for (const GenerationCost& cost : costs) rows += to_json(cost) + "\n";
  for (const EvaluatedGroup& group : groups) rows += to_json(group) + "\n";
  return write_file(folder + "/tables.md", markdown).and_then([&] {
    return write_file(folder + "/rows.jsonl", rows);
  });
}

}  // namespace ccdfuzz
