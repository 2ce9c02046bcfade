#include "eval/evaluation_folder.hpp"

#include <fmt/format.h>

#include "eval/paper_tables.hpp"
#include "io/fields.hpp"
#include "io/output_file.hpp"

namespace ccdfuzz {

std::string answers_path(const std::string& folder) {
  return folder + "/answers.jsonl";
}

std::vector<NamedTable> evaluation_tables(const Rows& rows,
                                          const std::vector<GenerationCost>& costs) {
  std::vector<NamedTable> tables = {{"Performance", performance_table(by_kinds(rows))}};
  const auto add = [&](const char* title, Table table) {
    if (table.row_count() > 0) tables.push_back({title, std::move(table)});
  };
  add("Table 1, beside the paper's", paper_table_1(rows));
  add("Table 2, beside the paper's", paper_table_2(rows));
  add("Table 3, beside the paper's", paper_table_3(rows));
  add("Table 4: making the cases, beside the paper's", generation_table(costs));
  return tables;
}

Result<void> write_tables(const std::string& folder, const Rows& rows,
                          const std::vector<GenerationCost>& costs) {
  std::string markdown, lines;
  for (const auto& [title, table] : evaluation_tables(rows, costs)) {
    markdown +=
        fmt::format("{}## {}\n\n{}", markdown.empty() ? "" : "\n", title, table.to_markdown());
  }
  for (const GenerationCost& cost : costs) lines += to_json(cost) + "\n";
  for (const Row& row : by_kinds(rows)) lines += to_json(row) + "\n";
  return write_file(folder + "/tables.md", markdown).and_then([&] {
    return write_file(folder + "/rows.jsonl", lines);
  });
}

}  // namespace ccdfuzz
