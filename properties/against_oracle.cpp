#include "properties/against_oracle.hpp"

#include <fmt/format.h>

#include "case/case_json.hpp"
#include "case/judge.hpp"
#include "certify/checker/check_case.hpp"
#include "certify/checker/check_truth.hpp"
#include "generators/draw_patch.hpp"

namespace ccdfuzz {

Decided decide_briefly(const Query& query, std::uint64_t max_pops) {
  OracleOptions little;
  little.max_pops = max_pops;
  little.max_tree_nodes = 10 * max_pops;
  Decided decided;
  decided.known.query = query;
  const Decision decision = decide(query, little);
  decided.known.truth = decision.truth;
  if (const auto checked = check_truth(decided.known); !checked) {
    decided.check = Check::fails(fmt::format("the checker refuses the oracle: {}\n{}",
                                             checked.error().message(), to_json(decided.known)));
  } else if (decision.truth.clearance) {
    const auto shown = check_clearance(query, *decision.truth.clearance, decision.tree);
    if (!shown) {
      decided.check =
          Check::fails(fmt::format("{}\n{}", shown.error().message(), to_json(decided.known)));
    }
  }
  return decided;
}

Check not_contradicted(const std::string& name, Method& method, const Case& known,
                       const SearchOptions& options) {
  const Outcome outcome = judge(checked_contact(known), method.answer(known.query, options));
  if (!is_false_negative(outcome)) return Check::holds();
  return Check::fails(fmt::format("{} is {} on\n{}", name, name_of(outcome), to_json(known)));
}

Check claims_agree(const Query& query, std::uint64_t max_pops, const SearchOptions& search) {
  const Decided decided = decide_briefly(query, max_pops);
  if (decided.check.status == Check::Status::kFails) return decided.check;
  if (decided.known.truth.collides != true) return Check::holds();
  for (const char* name : kMissNothing) {
    const auto method = *make_method(name);
    Check check = not_contradicted(name, *method, decided.known, search);
    if (check.status == Check::Status::kFails) return check;
  }
  return Check::holds();
}

Check check_claims_agree_anywhere(Draw& choices) {
  Query query = draw_any_query(choices);
  // Numbers of one size touch more often than those of any.
  if (choices.coin()) {
    for (MovingPatch<double>& patch : query.patches) {
      for (Points<double>* points : {&patch.positions, &patch.velocities}) {
        for (Vec3<double>& p : *points) {
          for (int k = 0; k < 3; ++k) p[k] = static_cast<double>(choices.integer(-4, 4));
        }
      }
    }
    query.t_max = static_cast<double>(choices.integer(0, 4));
    // Their first corners meet, at a time of which they need not say so.
    if (choices.coin()) {
      const double t = static_cast<double>(choices.integer(0, 4));
      auto& [a, b] = query.patches;
      b.positions[0] = a.positions[0] + (a.velocities[0] - b.velocities[0]) * t;
    }
  }
  constexpr std::uint64_t kPops = 12;
  return claims_agree(query, kPops);
}

}  // namespace ccdfuzz
