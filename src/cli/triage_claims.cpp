#include "cli/triage_claims.hpp"

#include <fmt/format.h>

#include <optional>

#include "cli/check_find.hpp"
#include "cli/output.hpp"
#include "hunt/served_claim.hpp"

namespace ccdfuzz {

namespace {

class ClaimTriage {
 public:
  ClaimTriage(const ClaimTriageOptions& options, TriageWalk& walk)
      : options_(options), walk_(walk) {}

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
    const auto known = known_find(std::string(input->property.name), find.error);
    if (!known) return tl::unexpected(known.error());
    if (*known && (*known)->is_complete()) {
      ++counts.known;
      return true;
    }
    if (auto least = served.least(*input, run, {kShrinkTries, options_.stop})) {
      set_least(find, input->property, *std::move(least));
    }
    const SavedFind made(input->property, find);
    if (*known && !made.replaces(**known)) {
      ++counts.known;
      return !options_.stop();
    }
    const Result<std::string> saved = save_find(options_.folder, made);
    if (!saved) return tl::unexpected(saved.error());
    walk_.note_find();
    tell(file, input->property, find, made, *saved);
    return made.is_complete() || !options_.stop();
  }

 private:
  /// What stands in the folder, or what is complete elsewhere: what is not hides nothing here.
  Result<std::optional<SavedFind>> known_find(const std::string& property,
                                              const std::string& error) const {
    auto here = saved_find(options_.folder, property, error);
    if (!here || (*here && (*here)->is_complete()) || options_.known.empty()) return here;
    auto elsewhere = saved_find(options_.known, property, error);
    return !elsewhere || (*elsewhere && (*elsewhere)->is_complete()) ? elsewhere : here;
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
            const SavedFind& made, const std::string& saved) const {
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
    const char* state = made.is_complete() ? ""
                        : find.least       ? ", not shrunk to the end"
                                           : ", not shrunk";
    print_out(fmt::format("{}: {}{}: {}\n", what, property.name, state, saved));
  }

  const ClaimTriageOptions& options_;
  TriageWalk& walk_;
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
