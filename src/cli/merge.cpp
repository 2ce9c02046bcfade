#include "cli/merge.hpp"

#include <algorithm>
#include <filesystem>

#include "cli/command.hpp"
#include "eval/evaluation_folder.hpp"

namespace ccdfuzz {

namespace {

struct MergeArguments {
  std::vector<std::string> inputs;
  std::string output;
};

Result<int> run_merge(const MergeArguments& options) {
  const auto is_folder = [](const std::string& path) {
    return std::filesystem::is_directory(path);
  };
  const auto folders = std::ranges::count_if(options.inputs, is_folder);
  if (folders == 0) return merge_data_sets(options.inputs, options.output);
  if (static_cast<size_t>(folders) < options.inputs.size()) {
    const auto file = std::ranges::find_if_not(options.inputs, is_folder);
    return input_error(*file, "is no folder, and others of the inputs are");
  }
  const bool evaluated = std::filesystem::exists(EvaluationFolder::answers_path(options.inputs[0]));
  return evaluated ? merge_evaluations(options.inputs, options.output)
                   : merge_corpora(options.inputs, options.output);
}

}  // namespace

void add_merge(CommandLine& line) {
  auto [command, options] = line.add<MergeArguments>(
      "merge", "Put the shares of a run together, as one run would have made it", run_merge);
  command
      .texts("input", options->inputs,
             "Data sets (generate), or folders of answers (evaluate), or corpora (hunt)")
      .required();
  command
      .text("-o,--output", options->output,
            "What to write: .jsonl or .jsonl.zst, or a folder; a corpus may be there already")
      .required();
  command.max_work();
}

}  // namespace ccdfuzz
