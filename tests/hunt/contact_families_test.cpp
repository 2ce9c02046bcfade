// Every kind of contact that the generators have.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "case/horizons.hpp"
#include "certify/oracle/oracle.hpp"
#include "files/case_json.hpp"
#include "generators/generate.hpp"
#include "method/ask.hpp"
#include "share.hpp"

namespace ccdfuzz {
namespace {

/// Calls check on the first cases of all families, classes and kinds.
template <class Check>
void for_each_contact(std::uint64_t count, const Check& check) {
  for (const Family family : kFamilies) {
    for (const ContactClass contact : kContactClasses) {
      for (const CaseKind kind : {CaseKind::kRP, CaseKind::kRN}) {
        if (family == Family::kRegular || !is_made(family, contact, kind)) continue;
        GeneratorOptions options;
        options.family = family;
        options.contact = contact;
        options.kind = kind;
        for (std::uint64_t index = 0; index < count; index += kOneIn) {
          SCOPED_TRACE(fmt::format("--family {} --contact {} --kind {} --first {}", name_of(family),
                                   name_of(contact), name_of(kind), index));
          check(generate(options, index).value);
        }
      }
    }
  }
}

// At the contact and past it, where it shows if they come late.
TEST(ContactFamilies, TdibmCAndTheOracleMissNone) {
  MethodSet methods;
  SearchOptions limit;
  limit.max_pops = 400;
  OracleOptions oracle_limit;
  oracle_limit.max_pops = 200;
  oracle_limit.max_tree_nodes = 500;
  int decided = 0, all = 0;
  for_each_contact(1, [&](const Case& known) {
    std::vector<Case> asked = {known};
    if (const auto later = at_horizon(known, 1.5)) asked.push_back(*later);
    for (const Case& c : asked) {
      const Judged judged = ask(methods["tdibm-c"], c, limit);
      EXPECT_FALSE(is_false_negative(judged.outcome)) << to_json(c);
      decided += judged.outcome == Outcome::kCorrect;
      ++all;
    }
    const auto found = decide(known.query, oracle_limit).truth.collides;
    EXPECT_TRUE(!found || found == known.truth.collides) << to_json(known);
  });
  EXPECT_GT(decided, all / 2);
}

}  // namespace
}  // namespace ccdfuzz
