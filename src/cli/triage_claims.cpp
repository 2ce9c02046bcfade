#include "cli/triage_claims.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <map>
#include <set>

#include "cli/check_find.hpp"
#include "cli/output.hpp"
#include "hunt/claim_apart.hpp"

namespace ccdfuzz {

namespace {

namespace fs = std::filesystem;

class ClaimTriage {
 public:
  ClaimTriage(const ClaimTriageOptions& options, TriageWalk& walk)
      : options_(options), walk_(walk) {
    for (const SavedFind& find : saved_finds(options.folder)) {
      if (find.complete) {
        had_.insert(find.kind);
      } else {
        unfinished_[find.kind].insert(find.path);
      }
    }
    if (options.known.empty()) return;
    for (const SavedFind& find : saved_finds(options.known)) {
      if (find.complete) had_.insert(find.kind);
    }
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
    const std::string kind = kind_of_find(input->property, find);
    if (had_.contains(kind)) {
      ++counts.known;
      return {};
    }
    if (auto least = apart.least(*input, run, {kShrinkTries, options_.stop})) {
      set_least(find, input->property, *std::move(least));
    }
    const Result<std::string> saved = save_find(options_.folder, input->property, find);
    if (!saved) return tl::unexpected(saved.error());
    replace_unfinished(kind, *saved, is_complete(find));
    walk_.note_find();
    tell(file, input->property, find, *saved);
    return {};
  }

 private:
  /// What is not complete is known by nobody, and gives way to the next of its kind.
  void replace_unfinished(const std::string& kind, const std::string& saved, bool complete) {
    std::set<std::string>& before = unfinished_[kind];
    before.erase(saved);
    std::error_code none;
    for (const std::string& path : before) fs::remove(path, none);
    before.clear();
    if (complete) {
      had_.insert(kind);
    } else {
      before.insert(saved);
    }
  }

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
                  {"fails_again", find.least.has_value()},
                  {"cut_short", find.least && find.least->is_cut_short},
                  {"saved", saved}});
      return;
    }
    const char* state = is_complete(find) ? ""
                        : find.least      ? ", not shrunk to the end"
                                          : ", not shrunk";
    print_out(fmt::format("{}: {}{}: {}\n", what, property.name, state, saved));
  }

  const ClaimTriageOptions& options_;
  TriageWalk& walk_;
  std::set<std::string> had_;                                ///< kinds
  std::map<std::string, std::set<std::string>> unfinished_;  ///< kind to files of the folder
};

}  // namespace

Result<void> triage_claims(const ClaimTriageOptions& options, const std::vector<std::string>& files,
                           TriageWalk& walk) {
  if (const Result<void> made = make_find_folder(options.folder); !made) return made;
  ClaimTriage triage(options, walk);
  return walk.go(files, [&](const std::string& file) -> Result<TriageWalk::Work> {
    Result<std::vector<std::uint8_t>> bytes = read_bytes(file);
    if (!bytes) return tl::unexpected(bytes.error());
    return [&triage, file, bytes = *std::move(bytes)] { return triage.add(file, bytes); };
  });
}

}  // namespace ccdfuzz
