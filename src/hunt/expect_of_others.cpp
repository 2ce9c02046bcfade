#include "hunt/expect_of_others.hpp"

#include <algorithm>

#include "certify/checker/check_case.hpp"

namespace ccdfuzz {

void expect_of_others(Case& find, const std::vector<std::string>& methods, MethodSet& asked,
                      SearchOptions search, const std::string& trees,
                      const std::function<void(const std::string&, const Judged&)>& decided) {
  search.max_pops = std::min(search.max_pops, kEnoughPops);
  const CheckedCase known = checked_or_unknown(find, trees);
  for (const std::string& method : methods) {
    if (find.expect.contains(method)) continue;
    const Judged judged = ask(asked[method], known, search);
    if (judged.outcome == Outcome::kUndecided || judged.outcome == Outcome::kNotAsked) continue;
    find.expect[method] = {judged.outcome, judged.error};
    if (decided) decided(method, judged);
  }
}

}  // namespace ccdfuzz
