#include <fmt/format.h>

#include "base/table.hpp"
#include "case/tree_file.hpp"
#include "ccd/rational/proves_clear.hpp"
#include "certify/checker/check_case.hpp"
#include "certify/checker/shown.hpp"
#include "cli/command.hpp"
#include "cli/common_options.hpp"
#include "cli/interrupt.hpp"
#include "cli/output.hpp"
#include "cli/terminal.hpp"
#include "eval/stream_cases.hpp"

namespace ccdfuzz {

namespace {

struct VerifyArguments {
  std::vector<std::string> files;
  int threads = 1;
  bool json = false;
};

enum class Standing {
  kHolds,          ///< whether the patches touch in [0, t_max] is proven by a certificate
  kHoldsByMethod,  ///< that they do not has no certificate: the exact method found it again
  kRefuted,        ///< exact arithmetic contradicts the case
  kUnproven,       ///< the absence of contact that it claims could not be proven again
  kNoClaim,        ///< the case says neither that there is a contact nor until when there is none
};

std::string name_of(Standing standing) {
  switch (standing) {
    case Standing::kHolds:
      return "holds";
    case Standing::kHoldsByMethod:
      return "holds by method";
    case Standing::kRefuted:
      return "refuted";
    case Standing::kUnproven:
      return "unproven";
    case Standing::kNoClaim:
      return "no claim";
  }
  return "?";
}

struct Verified {
  Standing standing = Standing::kHolds;
  std::string note;
};

/// Everything the case claims: all that has a certificate by the checker, whatever else it says of
/// absence by the exact method, a run of which is no certificate.
Verified verify(const NamedCase& named) {
  const Case& value = named.value;
  const Truth& truth = value.truth;
  if (const auto checked = check_case(value, trees_path(named.file)); !checked) {
    return {Standing::kRefuted, checked.error().message()};
  }
  if (!truth.collides && !truth.clear_until && !truth.clearance) {
    return {Standing::kNoClaim, "the case has no truth"};
  }
  if (truth.clearance) return {};  // check_case: it proves all that is said of absence
  Rational clear_until = 0;
  if (truth.collides == false) clear_until = exact(value.query.t_max);
  // A later claim includes an earlier one, also at the very end: [0, c) lies in [0, c].
  if (truth.clear_until && *truth.clear_until > clear_until) clear_until = *truth.clear_until;
  if (truth.collides != false && clear_until == 0) return {};
  if (!proves_clear(value.query, clear_until)) {
    return {Standing::kUnproven,
            fmt::format("no proof found that nothing touches up to t = {}", shown(clear_until))};
  }
  // That there is a contact is proven all the same.
  if (truth.collides == true) {
    return {Standing::kHolds, fmt::format("clear until t = {} by method", shown(clear_until))};
  }
  return {Standing::kHoldsByMethod, ""};
}

Result<int> run_verify(const VerifyArguments& options) {
  std::array<std::uint64_t, 5> counts{};
  Table table({{"case", Align::kLeft}, {"truth", Align::kLeft}, {"why", Align::kLeft}});
  Progress progress;
  const std::atomic<bool>& interrupted = catch_interrupts();
  std::uint64_t done = 0;
  const Result<void> read = stream_cases<NamedCase, Verified>(
      options.files, 1, options.threads,
      [](const NamedCase& named, size_t) -> Result<Verified> { return verify(named); },
      [&](const NamedCase& named, size_t, const Verified& verified, double share) {
        const std::string& id = named.id;
        ++done;
        ++counts[static_cast<size_t>(verified.standing)];
        if (options.json) {
          nlohmann::ordered_json row = {{"case", id}, {"truth", name_of(verified.standing)}};
          if (!verified.note.empty()) row["note"] = verified.note;
          print_json(row);
        } else if (verified.standing > Standing::kHoldsByMethod) {
          table.add_row({{id}, {name_of(verified.standing), Emphasis::kBad}, {verified.note}});
          print_full_rows(table);
        }
        progress.show(share, id, done, "cases");
      },
      &interrupted);
  progress.clear();
  if (table.row_count() > 0) {
    print_last_rows(table);
    print_out("\n");
  }
  if (!read) return tl::unexpected(read.error());
  const auto [hold, by_method, refuted, unproven, no_claim] = counts;
  if (!options.json) {
    std::string summary = fmt::format("{} cases: {} hold, ", done, hold);
    if (by_method > 0) summary += fmt::format("{} hold by method, ", by_method);
    summary += fmt::format("{} refuted, {} unproven", refuted, unproven);
    if (no_claim > 0) summary += fmt::format(", {} without a truth", no_claim);
    print_out(summary + "\n");
  }
  if (interrupted) return interrupted_exit_code();
  return refuted + unproven == 0 ? kDone : kCheckFailed;
}

}  // namespace

void add_verify(CommandLine& line) {
  auto [command, options] =
      line.add<VerifyArguments>("verify",
                                "Check the certificates of cases in exact arithmetic; what they "
                                "say of absence without one is "
                                "told apart, as \"by method\"",
                                run_verify);
  command.texts("case", options->files, "Case files: .json, .jsonl or .jsonl.zst").required();
  add_threads(command, options->threads);
  command.flag("--json", options->json, "One JSON object per case");
}

}  // namespace ccdfuzz
