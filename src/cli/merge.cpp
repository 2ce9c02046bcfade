#include "cli/merge.hpp"

#include <fmt/format.h>

#include "cli/command.hpp"

namespace ccdfuzz {

namespace {

struct MergeArguments {
  std::vector<std::string> inputs;
  std::string output;
};

Result<int> run_merge(const MergeArguments& options) {
  return merge_data_sets(options.inputs, options.output);
}

}  // namespace

void add_merge(CommandLine& line) {
  auto [command, options] = line.add<MergeArguments>(
      "merge", "Put the shares of a run together, as one run would have made it", run_merge);
  command.texts("input", options->inputs, "Data sets").required();
  command.text("-o,--output", options->output, "What to write: .jsonl or .jsonl.zst").required();
}

}  // namespace ccdfuzz
