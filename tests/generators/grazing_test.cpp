
#include <gtest/gtest.h>

#include "ccd/rational/proves_clear.hpp"
#include "generators/generate.hpp"

namespace ccdfuzz {
namespace {

// What a search of few pops does not prove is thrown away, and no claim is made without a proof.
TEST(Grazing, FewPopsThrowAwayMore) {
  GeneratorOptions options{.contact = ContactClass::kFF,
                           .kind = CaseKind::kNHP,
                           .construction = Construction::kOneSided};
  constexpr std::uint64_t kPops = 1000;
  DiscardCounts many, few;
  for (std::uint64_t i = 0; i < 6; ++i) {
    options.proof_pops = GeneratorOptions().proof_pops;
    many += generate(options, i).discards;
    options.proof_pops = kPops;
    const Generated made = generate(options, i);
    few += made.discards;
    EXPECT_TRUE(proves_clear(made.value.query, *made.value.truth.clear_until, {.pops = kPops}))
        << i;
  }
  EXPECT_GT(few[Discard::kFirstContact], many[Discard::kFirstContact]);
}

}  // namespace
}  // namespace ccdfuzz
