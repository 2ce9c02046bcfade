#include <fmt/format.h>

#include "cli/command.hpp"
#include "cli/merge.hpp"

namespace ccdfuzz {

namespace {

struct CorpusArguments {
  std::vector<std::string> words;
  std::string output;
};

Result<int> run_corpus(const CorpusArguments& options) {
  if (options.words.front() != "merge") {
    return input_error("corpus", fmt::format("\"{}\" is not one of merge", options.words.front()));
  }
  const std::vector<std::string> inputs(options.words.begin() + 1, options.words.end());
  if (inputs.empty()) return input_error("corpus merge", "name the corpora to merge");
  return merge_corpora(inputs, options.output);
}

}  // namespace

void add_corpus(CommandLine& line) {
  auto [command, options] = line.add<CorpusArguments>(
      "corpus", "corpus merge A B... -o C: of each failure the smallest case", run_corpus);
  command.texts("merge", options->words, "`merge`, and the folders of cases to merge").required();
  command.text("-o,--output", options->output, "Folder to add them to; may be there already")
      .required();
}

}  // namespace ccdfuzz
