#include "eval/generation_cost.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "eval/paper_rates.hpp"
#include "files/case_files.hpp"
#include "io/line_reader.hpp"
#include "io/output_file.hpp"

namespace ccdfuzz {

namespace {

/// How often constructions were thrown away in a step, which comes last if it is not there yet.
std::uint64_t& discarded_in(GenerationCost& cost, const std::string& step) {
  for (auto& [known, count] : cost.discarded) {
    if (known == step) return count;
  }
  return cost.discarded.emplace_back(step, 0).second;
}

}  // namespace

GenerationCost& GenerationCost::operator+=(const GenerationCost& o) {
  cases += o.cases;
  begun += o.begun;
  cpu_seconds += o.cpu_seconds;
  for (const auto& [step, count] : o.discarded) discarded_in(*this, step) += count;
  return *this;
}

std::string costs_path(const std::string& case_path) {
  return case_path + std::string(kCostsEnding);
}

Result<std::vector<GenerationCost>> read_costs(const std::vector<std::string>& case_paths) {
  constexpr size_t kLongestCost = 1 << 16;
  std::vector<GenerationCost> costs;
  for (const std::string& case_path : case_paths) {
    const std::string path = costs_path(case_path);
    if (!std::filesystem::is_regular_file(path)) continue;
    CCDFUZZ_TRY(auto lines, LineReader::open(path, false, kLongestCost));
    for (;;) {
      CCDFUZZ_TRY(const auto line, lines.next());
      if (!line) break;
      CCDFUZZ_TRY(const auto cost,
                  from_json<GenerationCost>(*line, fmt::format("{}:{}", path, lines.line())));
      add_cost(costs, cost);
    }
  }
  return costs;
}

Result<void> write_costs(const std::string& case_path, const std::vector<GenerationCost>& costs) {
  if (is_stream(case_path)) return {};
  const std::string path = costs_path(case_path);
  std::error_code error;
  if (costs.empty() && std::filesystem::is_regular_file(path, error)) {
    std::filesystem::remove(path, error);
    return error ? system_error(path, "remove", error.value()) : Result<void>();
  }
  if (costs.empty()) return {};
  std::string lines;
  for (const GenerationCost& cost : costs) lines += to_json(cost) + "\n";
  return write_file(path, lines);
}

void add_cost(std::vector<GenerationCost>& to, const GenerationCost& cost) {
  const auto same = std::ranges::find_if(to, [&](const GenerationCost& c) {
    return c.contact == cost.contact && c.kind == cost.kind;
  });
  if (same == to.end()) {
    to.push_back(cost);
  } else {
    *same += cost;
  }
}

Table generation_table(std::vector<GenerationCost> costs) {
  GenerationCost total;
  total.contact = "all";
  for (const GenerationCost& cost : costs) total += cost;
  std::erase_if(total.discarded, [](const auto& step) { return step.second == 0; });
  std::vector<Table::Column> columns = {
      {"class", Align::kLeft},    {"kind", Align::kLeft},        {"cases"},
      {"each", Align::kRight, 7}, {"paper's", Align::kRight, 7}, {"begun"}};
  for (const auto& [step, count] : total.discarded) columns.push_back({step});
  Table table(columns);
  if (costs.size() > 1) costs.push_back(total);
  for (GenerationCost& cost : costs) {
    if (&cost != &costs.front() && cost.contact != (&cost)[-1].contact) table.start_group();
    const std::optional<double> papers = paper_generation_seconds(cost.contact, cost.kind);
    std::vector<TableCell> cells = {
        {cost.contact},
        {cost.kind},
        {fmt::format("{}", cost.cases)},
        {cost.cases == 0 ? "-" : duration_text(cost.cpu_seconds / static_cast<double>(cost.cases))},
        {papers ? duration_text(*papers) : "-"},
        {fmt::format("{}", cost.begun)}};
    for (const auto& [step, all] : total.discarded) {
      cells.push_back({count_text(discarded_in(cost, step), cost.begun)});
    }
    table.add_row(std::move(cells));
  }
  return table;
}

}  // namespace ccdfuzz
