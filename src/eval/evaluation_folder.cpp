#include "eval/evaluation_folder.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "base/csv.hpp"
#include "base/input_bytes.hpp"
#include "base/json_text.hpp"
#include "eval/paper_tables.hpp"

namespace ccdfuzz {

namespace {

constexpr const char* kEvaluationFormat = "ccdfuzz-evaluation";
/// So many bytes of answers are handed to the system at once.
constexpr size_t kAnswersPiece = 1 << 16;

/// The first line of rows.jsonl.
std::string head_json(const EvaluationRun& run, size_t costs) {
  const nlohmann::ordered_json json = {{"format", kEvaluationFormat},
                                       {"version", 2},
                                       {"asked", run.asked},
                                       {"methods", run.methods},
                                       {"shard", {run.shard.index, run.shard.of}},
                                       {"costs", costs}};
  return json_text(json) + "\n";
}

/// Reads that line into a run; the number of costs that follow.
Result<size_t> read_head(const std::string& line, const std::string& path, EvaluationRun& run) {
  size_t costs = 0;
  try {
    const auto json = nlohmann::ordered_json::parse(line);
    if (json.at("format") != kEvaluationFormat || json.at("version") != 2) {
      throw std::invalid_argument("is not of the format ccdfuzz-evaluation, version 2");
    }
    json.at("asked").get_to(run.asked);
    json.at("methods").get_to(run.methods);
    json.at("shard").at(0).get_to(run.shard.index);
    json.at("shard").at(1).get_to(run.shard.of);
    json.at("costs").get_to(costs);
  } catch (const std::exception& error) {
    return input_error(path, error.what());
  }
  if (run.shard.index >= run.shard.of) return input_error(path, "shard: there is no such share");
  return costs;
}

std::string rows_path(const std::string& folder) {
  return folder + "/rows.jsonl";
}

}  // namespace

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

Result<EvaluationFolder> EvaluationFolder::open(const std::string& folder, EvaluationRun run) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) return input_error(folder, "cannot make the folder: " + error.message());
  Result<OutputFile> answers = OutputFile::create(answers_path(folder));
  if (!answers) return tl::unexpected(answers.error());
  EvaluationFolder opened(folder, std::move(run), *std::move(answers));
  opened.pending_ = csv_header<AnswerRecord>() + "\n";
  return opened;
}

Result<void> EvaluationFolder::add(const AnswerRecord& record) {
  groups_.add(record);
  pending_ += csv_row(record) + "\n";
  if (pending_.size() < kAnswersPiece) return {};
  const Result<void> written = answers_.write(pending_);
  pending_.clear();
  return written;
}

Result<void> EvaluationFolder::finish(const std::vector<GenerationCost>& costs) {
  const std::vector<EvaluatedGroup> groups = groups_.in_order();
  std::string markdown, rows = head_json(run_, costs.size());
  for (const auto& [title, table] : evaluation_tables(groups, costs)) {
    markdown +=
        fmt::format("{}## {}\n\n{}", markdown.empty() ? "" : "\n", title, table.to_markdown());
  }
  for (const GenerationCost& cost : costs) rows += to_json(cost) + "\n";
  for (const EvaluatedGroup& group : groups) rows += to_json(group) + "\n";
  Result<void> done = write_file(folder_ + "/tables.md", markdown);
  if (done) done = write_file(rows_path(folder_), rows);
  if (done) done = answers_.write(pending_);
  return done ? answers_.commit() : done;
}

Result<EvaluatedFolder> EvaluatedFolder::open(const std::string& folder) {
  EvaluatedFolder opened;
  opened.folder_ = folder;
  const std::string path = rows_path(folder), answers = EvaluationFolder::answers_path(folder);
  for (const std::string& file : {path, answers}) {
    if (auto regular = refuse_irregular(file); !regular) return tl::unexpected(regular.error());
  }
  std::ifstream rows(path);
  std::string line;
  if (!std::getline(rows, line)) {
    return input_error(path,
                       "cannot be read: this is no folder of an evaluation, or an older version "
                       "wrote it: run `ccdfuzz evaluate -o` again");
  }
  const Result<size_t> costs = read_head(line, path, opened.run_);
  if (!costs) return tl::unexpected(costs.error());
  while (opened.costs_.size() < *costs) {
    line.clear();
    std::getline(rows, line);
    const std::string where = fmt::format("{}:{}", path, opened.costs_.size() + 2);
    Result<GenerationCost> cost = parse_cost(line, where);
    if (!cost) return tl::unexpected(cost.error());
    opened.costs_.push_back(*std::move(cost));
  }
  opened.answers_.open(answers);
  std::string header;
  if (!std::getline(opened.answers_, header) || header != csv_header<AnswerRecord>()) {
    return input_error(answers, "does not begin with the line of an evaluation's answers");
  }
  opened.line_ = 1;
  if (auto read = opened.advance(); !read) return tl::unexpected(read.error());
  return opened;
}

Result<void> EvaluatedFolder::advance() {
  std::string line;
  current_.reset();
  if (!std::getline(answers_, line)) return {};
  const std::string where = fmt::format("{}:{}", EvaluationFolder::answers_path(folder_), ++line_);
  Result<AnswerRecord> record = from_csv_row<AnswerRecord>(line, where);
  if (!record) return tl::unexpected(record.error());
  current_ = *std::move(record);
  return {};
}

}  // namespace ccdfuzz
