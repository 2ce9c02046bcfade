#include "finds/replay.hpp"

#include <fmt/format.h>

#include "method/plugin/plugin_spec.hpp"
#include "method/served_method.hpp"

namespace ccdfuzz {

namespace {

/// 0: correct; 1: nothing is claimed; 2: a failure.
int badness(Outcome outcome) {
  if (is_failure(outcome)) return 2;
  return outcome == Outcome::kCorrect ? 0 : 1;
}

}  // namespace

Change change_of(const Expected& expected, const Expected& got) {
  if (expected.outcome == got.outcome) {
    const bool is_alike = expected.cause.empty() || expected.cause == got.cause;
    return is_alike ? Change::kNone : Change::kOther;
  }
  const int before = badness(expected.outcome), now = badness(got.outcome);
  if (before == now) return Change::kOther;
  return before < now ? Change::kRegression : Change::kImprovement;
}

std::string to_text(const Expected& expected, double late_by) {
  std::string text(name_of(expected.outcome));
  if (late_by > 0) text += fmt::format(" by {:.3g}", late_by);
  if (!expected.cause.empty()) text += fmt::format(" ({})", expected.cause);
  return text;
}

Replayer::Replayer() : here_(SearchOptions()), served_({}, MethodSet(make_served_method)) {}

std::vector<ReplayRow> Replayer::replay(const std::string& id, const CheckedCase& known,
                                        const std::map<std::string, Expected>& expected,
                                        const SearchOptions& search) {
  std::vector<ReplayRow> rows;
  for (const auto& [method, expectation] : expected) {
    const bool may_end_its_process =
        expectation.outcome == Outcome::kError && !names_plugin(method);
    Asker& asker = may_end_its_process ? served_ : here_;
    Judged judged = asker.ask(method, known, search);
    Expected got = asker.expected(method, known.value(), judged);
    rows.push_back({id, method, expectation, std::move(got), std::move(judged)});
  }
  return rows;
}

}  // namespace ccdfuzz
