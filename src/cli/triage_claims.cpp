#include "cli/triage_claims.hpp"

#include <fmt/format.h>

#include <optional>

#include "cli/check_find.hpp"
#include "cli/session.hpp"
#include "hunt/served_claim.hpp"

namespace ccdfuzz {

namespace {

/// A find, as a row of the JSON output.
struct ClaimFindRow {
  const std::string& input;
  const ClaimFind& find;
  const std::string& path;

  std::string outcome() const { return find.error.empty() ? "refuted claim" : find.error; }

  static void fields(auto& archive, auto& row) {
    const ClaimFind& find = row.find;
    const bool fails_again = find.shrunk != Shrunk::kNot;
    archive.constant("row", "find");
    archive("input", row.input);
    archive("property", find.property);
    archive("outcome", row.outcome());
    archive("text", fails_again ? find.text : find.found);
    archive("reproduce", find.reproduce());
    archive("fails_again", fails_again);
    archive("cut_short", find.shrunk == Shrunk::kCutShort);
    archive("saved", row.path);
  }
};

class ClaimTriage {
 public:
  ClaimTriage(const ClaimTriageOptions& options, TriageWalk& walk)
      : options_(options), walk_(walk) {}

  /// Whether there is nothing left to do with it.
  bool add(const std::string& file, std::span<const std::uint8_t> bytes) {
    TriageTally& tally = walk_.counts().tally;
    ++tally.inputs;
    const auto input = claim_input(options_.suite, bytes);
    if (!input) {
      ++tally.harmless;
      return true;
    }
    const Property& property = input->property;
    ServedClaim served(property);
    const InputRun run = served.on(input->choices);
    if (!run.fails()) {
      ++tally.harmless;
      return true;
    }
    ++tally.failures;
    ClaimFind find(property, run.error, run.check.text,
                   check_command(property.name, input->choices));
    const std::optional<ClaimFind> known = known_find(find);
    if (known && known->is_complete()) {
      ++tally.known;
      return true;
    }
    if (const auto least = served.least(run, {kShrinkTries, options_.stop})) {
      find.set_least(*least);
    }
    if (known && !find.replaces(*known)) {
      ++tally.known;
      return !options_.stop();
    }
    const std::string path = need(save_find(options_.folder, find));
    walk_.note_find();
    tell({file, find, path});
    return find.is_complete() || !options_.stop();
  }

 private:
  /// What stands in the folder, or what is complete elsewhere: what is not hides nothing here.
  std::optional<ClaimFind> known_find(const ClaimFind& find) const {
    const auto in = [&](const std::string& folder) {
      return need(saved_find(folder, find.property, find.error));
    };
    std::optional<ClaimFind> here = in(options_.folder);
    if ((here && here->is_complete()) || options_.known.empty()) return here;
    std::optional<ClaimFind> elsewhere = in(options_.known);
    return elsewhere && elsewhere->is_complete() ? elsewhere : here;
  }

  void tell(const ClaimFindRow& row) const {
    if (options_.json) return print_row(row);
    const Shrunk shrunk = row.find.shrunk;
    const char* state = shrunk == Shrunk::kToTheEnd   ? ""
                        : shrunk == Shrunk::kCutShort ? ", not shrunk to the end"
                                                      : ", not shrunk";
    print_out(fmt::format("{}: {}{}: {}\n", row.outcome(), row.find.property, state, row.path));
  }

  const ClaimTriageOptions& options_;
  TriageWalk& walk_;
};

}  // namespace

void triage_claims(const ClaimTriageOptions& options, const std::vector<std::string>& files,
                   TriageWalk& walk) {
  need(make_find_folder(options.folder));
  ClaimTriage triage(options, walk);
  walk.go(files, [&](const std::string& file) {
    return read_bytes(file).map([&](std::vector<std::uint8_t> bytes) -> TriageWalk::Work {
      return [&triage, file, bytes = std::move(bytes)] { return triage.add(file, bytes); };
    });
  });
}

}  // namespace ccdfuzz
