#include "eval/generation_cost.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "eval/paper_rates.hpp"
#include "files/tree_file.hpp"
#include "io/line_reader.hpp"
#include "io/output_file.hpp"

namespace ccdfuzz {

std::uint64_t StepCounts::of(std::string_view step) const {
  const auto found = std::ranges::find_if(steps, [&](const auto& s) { return s.first == step; });
  return found == steps.end() ? 0 : found->second;
}

void JsonForm<StepCounts>::write(std::string& json, const StepCounts& counts) {
  json += '{';
  JsonWriter writer(json);
  for (const auto& [step, count] : counts.steps) writer(step, count);
  json += '}';
}

void JsonForm<StepCounts>::read(const JsonCursor& from, StepCounts& counts) {
  counts.steps.clear();
  for (const std::string& step : from.object().value().keys) {
    counts.steps.emplace_back(step, from.at(step).integer<std::uint64_t>());
  }
}

GenerationCost& GenerationCost::operator+=(const GenerationCost& o) {
  cases += o.cases;
  begun += o.begun;
  cpu_seconds += o.cpu_seconds;
  auto& steps = discarded.steps;
  for (const auto& [step, count] : o.discarded.steps) {
    auto same = std::ranges::find_if(steps, [&](const auto& s) { return s.first == step; });
    if (same == steps.end()) same = steps.insert(same, {step, 0});
    same->second += count;
  }
  return *this;
}

std::string costs_path(const std::string& case_path) {
  return path_beside(case_path, ".generation.jsonl");
}

Result<std::vector<GenerationCost>> read_costs(const std::string& case_path) {
  constexpr size_t kLongestCost = 1 << 16;
  const std::string path = costs_path(case_path);
  std::vector<GenerationCost> costs;
  if (!std::filesystem::is_regular_file(path)) return costs;
  CCDFUZZ_TRY(auto lines, LineReader::open(path, false, kLongestCost));
  for (;;) {
    CCDFUZZ_TRY(const auto line, lines.next());
    if (!line) return costs;
    CCDFUZZ_TRY(const auto cost,
                from_json<GenerationCost>(*line, fmt::format("{}:{}", path, lines.line())));
    add_cost(costs, cost);
  }
}

Result<std::vector<GenerationCost>> read_costs(const std::vector<std::string>& case_paths) {
  std::vector<GenerationCost> costs;
  for (const std::string& path : case_paths) {
    CCDFUZZ_TRY(const auto of_file, read_costs(path));
    for (const GenerationCost& cost : of_file) add_cost(costs, cost);
  }
  return costs;
}

Result<void> write_costs(const std::string& case_path, const std::vector<GenerationCost>& costs) {
  std::string lines;
  for (const GenerationCost& cost : costs) lines += to_json(cost) + "\n";
  return write_file(costs_path(case_path), lines);
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

Table generation_table(const std::vector<GenerationCost>& costs) {
  GenerationCost total;
  for (const GenerationCost& cost : costs) total += cost;
  std::vector<Table::Column> columns = {
      {"class", Align::kLeft},    {"kind", Align::kLeft},        {"cases"},
      {"each", Align::kRight, 7}, {"paper's", Align::kRight, 7}, {"begun"}};
  for (const auto& [step, count] : total.discarded.steps) columns.push_back({step});
  Table table(columns);
  const auto add = [&table, &total](const GenerationCost& cost, const std::string& papers) {
    std::vector<TableCell> cells = {
        {cost.contact},
        {cost.kind},
        {fmt::format("{}", cost.cases)},
        {cost.cases == 0 ? "-" : duration_text(cost.cpu_seconds / static_cast<double>(cost.cases))},
        {papers},
        {fmt::format("{}", cost.begun)}};
    for (const auto& [step, all] : total.discarded.steps) {
      const std::uint64_t count = cost.discarded.of(step);
      cells.push_back(
          {count_text(count, cost.begun), count == 0 ? Emphasis::kFaint : Emphasis::kPlain});
    }
    table.add_row(std::move(cells));
  };
  for (const GenerationCost& cost : costs) {
    if (&cost != &costs.front() && cost.contact != (&cost)[-1].contact) table.start_group();
    const std::optional<double> papers = paper_generation_seconds(cost.contact, cost.kind);
    add(cost, papers ? duration_text(*papers) : "-");
  }
  if (costs.size() > 1) {
    total.contact = "all";
    table.start_group();
    add(total, "-");
  }
  return table;
}

}  // namespace ccdfuzz
