#include "properties/against_oracle.hpp"

#include <fmt/format.h>

#include "certify/checker/check_case.hpp"
#include "certify/checker/check_truth.hpp"
#include "certify/oracle/oracle.hpp"
#include "files/case_json.hpp"

namespace ccdfuzz {

const std::vector<std::string>& miss_nothing() {
  static const std::vector<std::string> specs =
      every_method_but({"oracle"}, &MethodInfo::claim_is_proven);
  return specs;
}

Case decide_briefly(const Query& query, std::uint64_t max_pops) {
  Case known;
  known.query = query;
  known.truth = decide(query, {.max_pops = max_pops, .max_tree_nodes = 10 * max_pops}).truth;
  const auto claim_accepted = [&](const auto& checked) {
    if (checked) return;
    throw Refuted(fmt::format("the checker refuses the oracle:\n{}\n{}", checked.error().message(),
                              to_json(known)));
  };
  claim_accepted(check_truth(known));
  if (known.truth.clearance) {
    claim_accepted(check_clearance(query, *known.truth.clearance));
  }
  return known;
}

Outcome outcome_on(Method& method, const Case& known, const SearchOptions& options) {
  return judge(checked_contact(known), method.answer(known.query, options));
}

void claim_not_contradicted(const std::string& name, Method& method, const Case& known,
                            const SearchOptions& options) {
  const Outcome outcome = outcome_on(method, known, options);
  if (!is_false_negative(outcome)) return;
  throw Refuted(fmt::format("{} by {}:\n{}", name_of(outcome), name, to_json(known)));
}

void claim_all_agree(const Query& query, std::uint64_t max_pops, const SearchOptions& search) {
  const Case known = decide_briefly(query, max_pops);
  if (known.truth.collides != true) return;
  for (const std::string& name : miss_nothing()) {
    claim_not_contradicted(name, **make_method(name), known, search);
  }
}

}  // namespace ccdfuzz
