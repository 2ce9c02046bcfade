#include "eval/generation_record.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "base/json_text.hpp"
#include "base/output_file.hpp"
#include "base/verify.hpp"
#include "eval/paper_rates.hpp"

namespace ccdfuzz {

namespace {

using GenerationJson = nlohmann::ordered_json;

constexpr const char* kGenerationFormat = "ccdfuzz-generation";

GenerationCost from_row(const GenerationJson& row) {
  GenerationCost cost;
  row.at("contact").get_to(cost.contact);
  row.at("kind").get_to(cost.kind);
  row.at("cases").get_to(cost.cases);
  row.at("begun").get_to(cost.begun);
  for (const auto& [step, count] : row.at("discarded").items()) {
    cost.discarded.emplace_back(step, count.get<std::uint64_t>());
  }
  row.at("cpu_seconds").get_to(cost.cpu_seconds);
  return cost;
}

void read_generation_head(const GenerationJson& row, GenerationRecord& record) {
  if (row.at("format") != kGenerationFormat || row.at("version") != 1) {
    throw std::invalid_argument("is not of the format ccdfuzz-generation, version 1");
  }
  row.at("run").get_to(record.run);
  row.at("shard").at(0).get_to(record.shard.index);
  row.at("shard").at(1).get_to(record.shard.of);
  if (record.shard.index >= record.shard.of) throw std::invalid_argument("is of no such shard");
}

}  // namespace

std::string to_json(const GenerationCost& cost) {
  GenerationJson row = {
      {"contact", cost.contact}, {"kind", cost.kind}, {"cases", cost.cases}, {"begun", cost.begun}};
  for (const auto& [step, count] : cost.discarded) row["discarded"][step] = count;
  row["cpu_seconds"] = cost.cpu_seconds;
  return json_text(row);
}

Result<GenerationCost> parse_cost(const std::string& line, const std::string& where) {
  try {
    return from_row(GenerationJson::parse(line));
  } catch (const std::exception& error) {
    return input_error(where, error.what());
  }
}

GenerationCost& GenerationCost::operator+=(const GenerationCost& o) {
  if (begun == 0 && discarded.empty()) {
    for (const auto& [step, count] : o.discarded) discarded.emplace_back(step, 0);
  }
  CCDFUZZ_VERIFY(discarded.size() == o.discarded.size());
  cases += o.cases;
  begun += o.begun;
  cpu_seconds += o.cpu_seconds;
  for (size_t i = 0; i < discarded.size(); ++i) discarded[i].second += o.discarded[i].second;
  return *this;
}

std::string generation_path(const std::string& case_path) {
  for (const std::string_view ending : {".jsonl.zst", ".jsonl"}) {
    if (case_path.ends_with(ending)) {
      return case_path.substr(0, case_path.size() - ending.size()) + ".generation.jsonl";
    }
  }
  return case_path + ".generation.jsonl";
}

Result<std::optional<GenerationRecord>> read_generation(const std::string& path) {
  if (!std::filesystem::is_regular_file(path)) return std::nullopt;
  std::ifstream file(path);
  if (!file) return system_error(path, "read", errno);
  GenerationRecord record;
  size_t number = 0;
  for (std::string line; std::getline(file, line);) {
    const std::string where = fmt::format("{}:{}", path, ++number);
    if (number > 1) {
      Result<GenerationCost> cost = parse_cost(line, where);
      if (!cost) return tl::unexpected(cost.error());
      record.costs.push_back(*std::move(cost));
      continue;
    }
    try {
      read_generation_head(GenerationJson::parse(line), record);
    } catch (const std::exception& error) {
      return input_error(where, error.what());
    }
  }
  if (number == 0) return input_error(path, "is empty");
  return record;
}

Result<void> write_generation(const std::string& path, const GenerationRecord& record) {
  const GenerationJson head = {{"format", kGenerationFormat},
                               {"version", 1},
                               {"run", record.run},
                               {"shard", {record.shard.index, record.shard.of}}};
  std::string lines = json_text(head) + "\n";
  for (const GenerationCost& cost : record.costs) lines += to_json(cost) + "\n";
  return write_file(path, lines);
}

void merge_costs(std::vector<GenerationCost>& into, const std::vector<GenerationCost>& from) {
  for (const GenerationCost& cost : from) {
    const auto same = std::ranges::find_if(into, [&](const GenerationCost& c) {
      return c.contact == cost.contact && c.kind == cost.kind;
    });
    if (same == into.end()) {
      into.push_back(cost);
    } else {
      *same += cost;
    }
  }
}

Table generation_table(const std::vector<GenerationCost>& costs) {
  GenerationCost total;
  std::vector<Table::Column> columns = {
      {"class", Align::kLeft}, {"kind", Align::kLeft}, {"cases"}, {"each"}, {"paper's"}, {"begun"}};
  if (!costs.empty()) {
    for (const auto& [step, count] : costs[0].discarded) columns.push_back({step});
  }
  Table table(columns);
  const auto add = [&table](const GenerationCost& cost, const std::string& papers) {
    std::vector<TableCell> cells = {
        {cost.contact},
        {cost.kind},
        {fmt::format("{}", cost.cases)},
        {cost.cases == 0 ? "-" : duration_text(cost.cpu_seconds / static_cast<double>(cost.cases))},
        {papers},
        {fmt::format("{}", cost.begun)}};
    for (const auto& [step, count] : cost.discarded) {
      cells.push_back(
          {count_text(count, cost.begun), count == 0 ? Emphasis::kFaint : Emphasis::kPlain});
    }
    table.add_row(std::move(cells));
  };
  for (const GenerationCost& cost : costs) {
    total += cost;
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
