#include "sound.hpp"

#include <fmt/format.h>

#include "case/judge.hpp"
#include "case/scale.hpp"
#include "ccd/witness_trace/trace.hpp"
#include "certify/checker/check_case.hpp"
#include "certify/checker/check_truth.hpp"
#include "certify/oracle/oracle.hpp"
#include "planted.hpp"

namespace ccdfuzz {

namespace {

std::string wrong_answer(const char* method, const Case& known) {
  const Answer answer = (*make_method(method))->answer(known.query, kDriverSearch);
  const Outcome outcome = judge(checked_contact(known), answer);
  const bool wrong = is_false_negative(outcome) || outcome == Outcome::kError;
  return wrong ? fmt::format("{} is {}", method, name_of(outcome)) : "";
}

}  // namespace

std::string contradiction(const Query& query) {
  const int fault = planted::active_fault;
  planted::active_fault = 0;
  Case known;
  known.query = query;
  known.truth = decide(query, {.max_pops = 300, .max_tree_nodes = 2000}).truth;
  planted::active_fault = fault;
  if (const auto checked = check_truth(known); !checked) return checked.error().message();
  const bool ordinary = is_within_scale(query, kErrorBoundScale);
  for (const char* method : kSoundMethods) {
    if (!ordinary && std::string_view(method) == "tdibm-e") continue;
    const std::string wrong = wrong_answer(method, known);
    if (!wrong.empty()) return wrong;
  }
  return "";
}

std::string lost_contact(const Case& known, Look look, MethodSet& methods) {
  if (const auto checked = check_truth(known); !checked) return checked.error().message();
  const bool ordinary = is_within_scale(known.query, kErrorBoundScale);
  for (const char* method : kSoundMethods) {
    if (!ordinary && std::string_view(method) == "tdibm-e") continue;
    if (look.traces && known.truth.witness && check_taken(method, known.query)) {
      const Trace& trace =
          methods[method].trace(known.query, *known.truth.witness, {.precision = 0x1p-8});
      if (trace.lost) return fmt::format("{} loses a contact", method);
    }
    if (!look.asks) continue;
    const std::string wrong = wrong_answer(method, known);
    if (!wrong.empty()) return wrong;
  }
  return "";
}

}  // namespace ccdfuzz
