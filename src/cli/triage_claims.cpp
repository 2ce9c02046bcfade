#include "cli/triage_claims.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <map>
#include <set>

#include "cli/check_find.hpp"
#include "cli/output.hpp"
#include "hunt/served_claim.hpp"

namespace ccdfuzz {

namespace {

namespace fs = std::filesystem;

/// The best find of a kind, and the files of the folder that a better one takes the place of.
struct Had {
  FindQuality quality;
  std::set<std::string> replaceable;
};

class ClaimTriage {
 public:
  ClaimTriage(const ClaimTriageOptions& options, TriageWalk& walk)
      : options_(options), walk_(walk) {
    for (const SavedFind& find : saved_finds(options.folder)) {
      note(find.kind, find.quality);
      if (!find.quality.is_complete()) had_[find.kind].replaceable.insert(find.path);
    }
    if (options.known.empty()) return;
    // What is not complete elsewhere does not hide what is found here.
    for (const SavedFind& find : saved_finds(options.known)) {
      if (find.quality.is_complete()) note(find.kind, find.quality);
    }
  }

  /// Whether there is nothing left to do with it.
  Result<bool> add(const std::string& file, std::span<const std::uint8_t> bytes) {
    TriageCounts& counts = walk_.counts();
    ++counts.inputs;
    const auto input = claim_input(options_.target, bytes);
    if (!input) {
      ++counts.harmless;
      return true;
    }
    ServedClaim served(input->property);
    const InputRun run = served.on(*input);
    if (!run.fails()) {
      ++counts.harmless;
      return true;
    }
    ++counts.failures;
    CheckFind find = found_on(*input, run);
    const std::string kind = kind_of_find(input->property, find);
    const auto had = had_.find(kind);
    if (had != had_.end() && had->second.quality.is_complete()) {
      ++counts.known;
      return true;
    }
    if (auto least = served.least(*input, run, {kShrinkTries, options_.stop})) {
      set_least(find, input->property, *std::move(least));
    }
    if (had != had_.end() && !quality_of(find).replaces(had->second.quality)) {
      ++counts.known;
      return !options_.stop();
    }
    const Result<std::string> saved = save_find(options_.folder, input->property, find);
    if (!saved) return tl::unexpected(saved.error());
    replace(kind, *saved, quality_of(find));
    walk_.note_find();
    tell(file, input->property, find, *saved);
    return quality_of(find).is_complete() || !options_.stop();
  }

 private:
  void note(const std::string& kind, const FindQuality& quality) {
    const auto [had, is_first] = had_.try_emplace(kind, Had{quality, {}});
    if (quality.replaces(had->second.quality)) had->second.quality = quality;
  }

  void replace(const std::string& kind, const std::string& saved, const FindQuality& quality) {
    Had& had = had_[kind];
    std::error_code none;
    for (const std::string& path : had.replaceable) {
      if (path != saved) fs::remove(path, none);
    }
    had = {quality, {}};
    if (!quality.is_complete()) had.replaceable.insert(saved);
  }

  static CheckFind found_on(const ClaimInput& input, const InputRun& run) {
    return {run.check.text,
            input.seed ? check_command(input.property, *input.seed, 0)
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
    const char* state = quality_of(find).is_complete() ? ""
                        : find.least                   ? ", not shrunk to the end"
                                                       : ", not shrunk";
    print_out(fmt::format("{}: {}{}: {}\n", what, property.name, state, saved));
  }

  const ClaimTriageOptions& options_;
  TriageWalk& walk_;
  std::map<std::string, Had> had_;  ///< by kind
};

}  // namespace

Result<void> triage_claims(const ClaimTriageOptions& options, const std::vector<std::string>& files,
                           TriageWalk& walk) {
  if (Result<void> made = make_find_folder(options.folder); !made) return made;
  ClaimTriage triage(options, walk);
  return walk.go(files, [&](const std::string& file) -> Result<TriageWalk::Work> {
    Result<std::vector<std::uint8_t>> bytes = read_bytes(file);
    if (!bytes) return tl::unexpected(bytes.error());
    return [&triage, file, bytes = *std::move(bytes)] { return triage.add(file, bytes); };
  });
}

}  // namespace ccdfuzz
