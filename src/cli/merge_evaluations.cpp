#include <fmt/format.h>

#include <set>

#include "cli/merge.hpp"
#include "cli/output.hpp"
#include "eval/evaluation_folder.hpp"

namespace ccdfuzz {

namespace {

/// Errors: the folders are not the shares of one run, each once.
Result<void> check_shares(const std::vector<std::string>& inputs,
                          const std::vector<EvaluatedFolder>& folders) {
  std::set<std::uint64_t> seen;
  const EvaluationRun& first = folders.front().run();
  for (size_t i = 0; i < folders.size(); ++i) {
    const EvaluationRun& run = folders[i].run();
    if (run.asked != first.asked) {
      return input_error(inputs[i], fmt::format("was asked for \"{}\", and {} for \"{}\"",
                                                run.asked, inputs[0], first.asked));
    }
    if (run.shard.of != first.shard.of) {
      return input_error(inputs[i], fmt::format("is one of {} shares, and {} of {}", run.shard.of,
                                                inputs[0], first.shard.of));
    }
    if (!seen.insert(run.shard.index).second) {
      return input_error(inputs[i],
                         fmt::format("share {}/{} is there twice", run.shard.index, run.shard.of));
    }
  }
  for (std::uint64_t i = 0; i < first.shard.of; ++i) {
    if (!seen.contains(i)) {
      return input_error("merge", fmt::format("share {}/{} is missing", i, first.shard.of));
    }
  }
  return {};
}

}  // namespace

Result<int> merge_evaluations(const std::vector<std::string>& inputs, const std::string& output) {
  std::vector<EvaluatedFolder> folders;
  for (const std::string& input : inputs) {
    Result<EvaluatedFolder> folder = EvaluatedFolder::open(input);
    if (!folder) return tl::unexpected(folder.error());
    folders.push_back(*std::move(folder));
  }
  if (auto shares = check_shares(inputs, folders); !shares) return tl::unexpected(shares.error());
  EvaluationRun run = folders.front().run();
  run.shard = Shard{};
  Result<EvaluationFolder> merged = EvaluationFolder::open(output, run);
  if (!merged) return tl::unexpected(merged.error());
  std::uint64_t count = 0;
  for (;;) {
    EvaluatedFolder* next = nullptr;
    for (EvaluatedFolder& folder : folders) {
      if (!folder.current()) continue;
      if (!next || folder.current()->index < next->current()->index) next = &folder;
    }
    if (!next) break;
    Result<void> done = merged->add(*next->current());
    if (done) done = next->advance();
    if (!done) return tl::unexpected(done.error());
    ++count;
  }
  if (auto done = merged->finish(folders.front().costs()); !done) {
    return tl::unexpected(done.error());
  }
  print_out(fmt::format("{} answers of {} folders in {}\n", count, inputs.size(), output));
  return 0;
}

}  // namespace ccdfuzz
