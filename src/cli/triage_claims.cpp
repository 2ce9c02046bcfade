#include "cli/triage_claims.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <set>

#include "cli/check_find.hpp"
#include "cli/output.hpp"
#include "hunt/claim_apart.hpp"

namespace ccdfuzz {

namespace {

namespace fs = std::filesystem;

/// Runs of a property to shrink a failure of it.
constexpr std::uint64_t kShrinkTries = 4000;

/// What finds are told apart by, of those in a folder that save_find wrote.
std::set<std::string> kinds_in(const std::string& folder) {
  std::set<std::string> kinds;
  std::error_code none;  // there may be no folder yet
  for (const auto& entry : fs::directory_iterator(folder, none)) {
    if (auto kind = kind_of_find(entry.path().filename())) kinds.insert(*std::move(kind));
  }
  return kinds;
}

class ClaimTriage {
 public:
  ClaimTriage(const ClaimTriageOptions& options, TriageWalk& walk)
      : options_(options), walk_(walk), had_(kinds_in(options.folder)) {
    if (!options.known.empty()) had_.merge(kinds_in(options.known));
  }

  Result<void> add(const std::string& file, std::span<const std::uint8_t> bytes) {
    TriageCounts& counts = walk_.counts();
    ++counts.inputs;
    const auto input = claim_input(options_.target, bytes);
    if (!input) {
      ++counts.harmless;
      return {};
    }
    ClaimApart apart(input->property, {});
    const InputRun run = apart.on(*input);
    if (!run.fails()) {
      ++counts.harmless;
      return {};
    }
    ++counts.failures;
    CheckFind find = found_on(*input, run);
    if (!had_.insert(kind_of_find(input->property, find)).second) {
      ++counts.known;
      return {};
    }
    if (auto least = apart.least(*input, run, {kShrinkTries, options_.stop})) {
      set_least(find, input->property, *std::move(least));
    }
    const Result<std::string> saved = save_find(options_.folder, input->property, find);
    if (!saved) return tl::unexpected(saved.error());
    walk_.note_find();
    tell(file, input->property, find, *saved);
    return {};
  }

 private:
  static CheckFind found_on(const ClaimInput& input, const InputRun& run) {
    return {run.check.text,
            input.seed ? check_command(input.property, *input.seed)
                       : check_command(input.property, input.bytes),
            run.error,
            std::nullopt,
            "",
            ""};
  }

  void tell(const std::string& file, const Property& property, const CheckFind& find,
            const std::string& saved) const {
    const std::string what = find.error.empty() ? std::string(options_.target.find) : find.error;
    if (options_.json) {
      print_json({{"row", "find"},
                  {"input", file},
                  {"property", property.name},
                  {"outcome", what},
                  {"text", find.least ? find.least->check.text : find.text},
                  {"reproduce", find.least ? find.reproduce : find.as_found},
                  {"saved", saved}});
      return;
    }
    print_out(fmt::format("{}: {}: {}\n", what, property.name, saved));
  }

  const ClaimTriageOptions& options_;
  TriageWalk& walk_;
  std::set<std::string> had_;
};

}  // namespace

Result<void> triage_claims(const ClaimTriageOptions& options, const std::vector<std::string>& files,
                           TriageWalk& walk) {
  ClaimTriage triage(options, walk);
  return walk.go(files, [&](const std::string& file) -> Result<TriageWalk::Work> {
    Result<std::vector<std::uint8_t>> bytes = read_bytes(file);
    if (!bytes) return tl::unexpected(bytes.error());
    return [&triage, file, bytes = *std::move(bytes)] { return triage.add(file, bytes); };
  });
}

}  // namespace ccdfuzz
