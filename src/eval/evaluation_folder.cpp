#include "eval/evaluation_folder.hpp"

#include <fmt/format.h>

#include <charconv>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "eval/figures.hpp"
#include "eval/paper_tables.hpp"
#include "query/json_text.hpp"

namespace ccdfuzz {

namespace {

constexpr const char* kEvaluationFormat = "ccdfuzz-evaluation";
/// So many bytes of answers are handed to the system at once.
constexpr size_t kAnswersPiece = 1 << 16;

std::string run_json(const EvaluationRun& run) {
  const nlohmann::ordered_json json = {{"format", kEvaluationFormat},
                                       {"version", 1},
                                       {"asked", run.asked},
                                       {"methods", run.methods},
                                       {"shard", {run.shard.index, run.shard.of}}};
  return json_text(json) + "\n";
}

Result<EvaluationRun> read_run(const std::string& path) {
  std::ifstream file(path);
  if (!file) return input_error(path, "cannot be read: this is no folder of an evaluation");
  EvaluationRun run;
  try {
    const auto json = nlohmann::ordered_json::parse(file);
    if (json.at("format") != kEvaluationFormat || json.at("version") != 1) {
      throw std::invalid_argument("is not of the format ccdfuzz-evaluation, version 1");
    }
    json.at("asked").get_to(run.asked);
    json.at("methods").get_to(run.methods);
    json.at("shard").at(0).get_to(run.shard.index);
    json.at("shard").at(1).get_to(run.shard.of);
  } catch (const std::exception& error) {
    return input_error(path, error.what());
  }
  if (run.shard.index >= run.shard.of) return input_error(path, "shard: there is no such share");
  return run;
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
  opened.pending_ = answer_csv_header() + "\n";
  return opened;
}

Result<void> EvaluationFolder::add(const AnswerRecord& record) {
  groups_.add(record);
  pending_ += to_csv(record) + "\n";
  if (pending_.size() < kAnswersPiece) return {};
  const Result<void> written = answers_.write(pending_);
  pending_.clear();
  return written;
}

Result<void> EvaluationFolder::finish(const std::vector<GenerationCost>& costs,
                                      const std::string& curvatures) {
  const std::vector<EvaluatedGroup> groups = groups_.in_order();
  std::string markdown, lines;
  for (const auto& [title, table] : evaluation_tables(groups, costs)) {
    markdown +=
        fmt::format("{}## {}\n\n{}", markdown.empty() ? "" : "\n", title, table.to_markdown());
  }
  for (const EvaluatedGroup& group : groups) lines += to_json(group) + "\n";
  Result<void> done = write("tables.md", markdown);
  const auto then = [&](const char* name, const std::string& text) {
    if (done) done = write(name, text);
  };
  then("groups.jsonl", lines);
  then("performance.csv", performance_csv(groups));
  then("table_1.csv", paper_csv(compare_with_table_1(groups)));
  then("table_2.csv", paper_csv(compare_with_table_2(groups)));
  then("figure_5.csv", figure_5_header() + curvatures);
  then("figure_8.csv", figure_8_csv(groups));
  then("figure_9.csv", figure_9_csv(groups));
  if (done) {
    done = write_generation(folder_ + "/generation.jsonl", {run_.asked, run_.shard, costs});
  }
  then("table_4.csv", generation_csv(costs));
  then("run.json", run_json(run_));
  if (done) done = answers_.write(pending_);
  return done ? answers_.commit() : done;
}

Result<EvaluatedFolder> EvaluatedFolder::open(const std::string& folder) {
  EvaluatedFolder opened;
  opened.folder_ = folder;
  Result<EvaluationRun> run = read_run(folder + "/run.json");
  if (!run) return tl::unexpected(run.error());
  opened.run_ = *std::move(run);
  auto record = read_generation(folder + "/generation.jsonl");
  if (!record) return tl::unexpected(record.error());
  if (*record) opened.costs_ = std::move((*record)->costs);
  const std::string answers = EvaluationFolder::answers_path(folder);
  opened.answers_.open(answers);
  std::string header;
  if (!std::getline(opened.answers_, header) || header != answer_csv_header()) {
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
  Result<AnswerRecord> record = parse_answer_csv(line, where);
  if (!record) return tl::unexpected(record.error());
  current_ = *std::move(record);
  return {};
}

Result<void> EvaluatedFolder::for_each_curvature(
    const std::function<void(std::uint64_t, const std::string&)>& visit) const {
  const std::string path = folder_ + "/figure_5.csv";
  std::ifstream file(path);
  std::string line;
  if (!std::getline(file, line) || line + "\n" != figure_5_header()) {
    return input_error(path, "does not begin with the line of Fig. 5's data");
  }
  for (size_t number = 2; std::getline(file, line); ++number) {
    std::uint64_t index = 0;
    const auto [end, status] = std::from_chars(line.data(), line.data() + line.size(), index);
    if (status != std::errc() || *end != ',') {
      return input_error(fmt::format("{}:{}", path, number), "does not begin with a case's index");
    }
    visit(index, line + "\n");
  }
  return {};
}

}  // namespace ccdfuzz
