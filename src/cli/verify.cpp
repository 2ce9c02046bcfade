#include <fmt/format.h>

#include "ccd/rational/proves_clear.hpp"
#include "certify/checker/abbreviated.hpp"
#include "certify/checker/check_case.hpp"
#include "certify/checker/work.hpp"
#include "certify/oracle/oracle.hpp"
#include "cli/command.hpp"
#include "cli/common_options.hpp"
#include "cli/default_budget.hpp"
#include "cli/session.hpp"

namespace ccdfuzz {

namespace {

enum class Standing {
  kHolds,          ///< whether the patches touch in [0, t_max] is proven by a certificate
  kHoldsByMethod,  ///< that they do not has no certificate: the exact method found it again
  kRefuted,        ///< exact arithmetic contradicts the case
  kUnproven,       ///< what it claims could not be proven again, or would take too long
  kNoClaim,        ///< the case says neither that there is a contact nor until when there is none
};

constexpr std::array<std::string_view, 5> names_of(Standing) {
  return {"holds", "holds by method", "refuted", "unproven", "no claim"};
}

struct Verified {
  std::string id;
  Standing standing = Standing::kHolds;
  std::string note = {};

  static void fields(auto& archive, auto& verified) {
    archive("case", verified.id);
    archive("truth", verified.standing);
    archive.optional("note", verified.note);
  }
};

/// proves_clear within the work of a certificate, as which it counts, half of it for doubles.
/// Measured: there a pair of cells takes as long as 8 · work_of_a_pop operations. Returns whether
/// it is proven and whether a limit was met.
std::pair<bool, bool> method_proves(const Query& query, const Rational& until) {
  const std::uint64_t of_a_pop = 8 * work_of_a_pop(query);
  const ClearEffort most = {std::min(ClearEffort().pops, kMostWork / 2 / of_a_pop), kMostWork / 2};
  ClearEffort spent;
  const bool proven = proves_clear(query, until, most, &spent);
  do_work_here(spent.pops * of_a_pop + spent.work);
  return {proven, spent.pops >= most.pops || spent.work >= most.work};
}

/// A contact that is proven and refutes that nothing touches up to a time, of queries on which the
/// oracle spends little.
std::optional<Rational> contact_before(const Case& value, const Rational& clear_until) {
  if (!is_decided_exactly(value.query) || has_turns(value.query)) return std::nullopt;
  std::optional<Rational> by = decide(value.query).truth.contact_by();
  // The end is within what is claimed, unless it is clear_until alone.
  const bool is_at_end = by && *by == clear_until && value.truth.collides != false;
  if (by && (*by > clear_until || is_at_end)) by.reset();
  return by;
}

/// Everything the case claims. The checker proves all that has a certificate. Whatever else the
/// case says of absence the exact method decides, a run of which is no certificate.
Verified verify(const NamedCase& named) {
  const Case& value = named.value;
  const Truth& truth = value.truth;
  if (const auto checked = check_case(value); !checked) {
    const InputError& error = checked.error();
    return {named.id, error.is_limit ? Standing::kUnproven : Standing::kRefuted, error.message()};
  }
  if (!truth.collides && !truth.clear_until && !truth.clearance) {
    return {named.id, Standing::kNoClaim, "the case has no truth"};
  }
  if (truth.clearance) return {named.id};  // check_case: it proves all that is said of absence
  Rational clear_until = 0;
  if (truth.collides == false) clear_until = exact(value.query.t_max);
  // A later claim includes an earlier one, also at the very end: [0, c) lies in [0, c].
  if (truth.clear_until && *truth.clear_until > clear_until) clear_until = *truth.clear_until;
  if (truth.collides != false && clear_until == 0) return {named.id};
  if (const auto [proven, at_limit] = method_proves(value.query, clear_until); !proven) {
    if (const auto by = contact_before(value, clear_until)) {
      return {named.id, Standing::kRefuted,
              fmt::format("a contact by t = {} is proven, and the case has none up to t = {}",
                          abbreviated(*by), abbreviated(clear_until))};
    }
    return {named.id, Standing::kUnproven,
            fmt::format("no proof found {}that nothing touches up to t = {}",
                        at_limit ? "within the work of a case " : "", abbreviated(clear_until))};
  }
  // That there is a contact is proven all the same.
  if (truth.collides == true) {
    return {named.id, Standing::kHolds,
            fmt::format("clear until t = {} by method", abbreviated(clear_until))};
  }
  return {named.id, Standing::kHoldsByMethod};
}

int run_verify(const std::vector<std::string>& files, Session& session) {
  std::array<std::uint64_t, all_of(Standing{}).size()> counts{};
  session.begin_table({{"case", Align::kLeft}, {"truth", Align::kLeft}, {"why", Align::kLeft}});
  session.each_case<Verified>(
      CaseStream(files), [](const NamedCase& named) { return verify(named); },
      [&](const NamedCase&, const Verified& verified) {
        ++counts[static_cast<size_t>(verified.standing)];
        if (!session.json && verified.standing <= Standing::kHoldsByMethod) return;
        session.show(verified, [&]() -> std::vector<TableCell> {
          const std::string standing(name_of(verified.standing));
          return {{verified.id}, {standing, true}, {verified.note}};
        });
      });
  session.end_table(true);
  const auto [hold, by_method, refuted, unproven, no_claim] = counts;
  const std::uint64_t cases = hold + by_method + refuted + unproven + no_claim;
  std::string summary = fmt::format("{}: {} hold, ", counted(cases, "case", "cases"), hold);
  if (by_method > 0) summary += fmt::format("{} hold by method, ", by_method);
  summary += fmt::format("{} refuted, {} unproven", refuted, unproven);
  if (no_claim > 0) summary += fmt::format(", {} without a truth", no_claim);
  session.summary(summary);
  return session.exit_code(refuted + unproven == 0 ? kDone : kCheckFailed);
}

}  // namespace

void add_verify(CommandLine& line) {
  auto [command, files] = line.add<std::vector<std::string>>(
      "verify", "Check the certificates of cases in exact arithmetic", run_verify);
  command.example("a data set", "verify vv.jsonl.zst");
  command
      .texts("case", *files,
             "Case files: .json, .jsonl, .jsonl.zst or .csv. Absence without a certificate is "
             "counted apart, as \"by method\"")
      .required();
  command.json("One JSON object per case");
  command.max_work();
  command.threads();
}

}  // namespace ccdfuzz
