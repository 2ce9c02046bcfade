#include "hunt/triage.hpp"

#include <gmock/gmock.h>

#include "certify/checker/check_truth.hpp"
#include "fuzz/mutator/witnessed_query.hpp"
#include "hunt/draw.hpp"
#include "query/case_json.hpp"
#include "scratch_folder.hpp"

namespace ccdfuzz {
namespace {

constexpr const char* kFails = "tdibm";

TriageOptions quick_options() {
  TriageOptions options;
  options.methods = {kFails, "tdibm-c"};
  options.search.max_pops = 2000;
  options.shrink_trials = 60;
  return options;
}

/// Contacts as a fuzzer hands them over: nothing is known but the contact.
std::vector<Case> raw_finds() {
  std::vector<Case> finds;
  for (std::uint64_t i = 0; i < 4; ++i) {
    for (const Case& asked : draw(ContactClass::kVV, 3, i).asked) {
      if (const auto q = witnessed_query(asked)) finds.push_back(case_of(*q));
    }
  }
  return finds;
}

std::vector<TriageFind> triaged(Triage& triage, const std::vector<Case>& raw) {
  std::vector<TriageFind> finds;
  for (const Case& candidate : raw) {
    EXPECT_TRUE(triage.add(candidate, [&](const TriageFind& find) { finds.push_back(find); }));
  }
  return finds;
}

TEST(Triage, StoresWhatFailsShrunkWithItsTruthAndFindsNothingTwice) {
  const ScratchFolder folder;
  const std::vector<Case> raw = raw_finds();
  Store store = Store::open(folder.path()).value();
  Triage first(store, quick_options());
  const std::vector<TriageFind> finds = triaged(first, raw);
  ASSERT_GE(finds.size(), 1U);
  std::set<std::string> losses;
  for (const TriageFind& find : finds) {
    EXPECT_EQ(find.method, kFails);
    EXPECT_TRUE(is_false_negative(find.outcome));
    EXPECT_EQ(find.value.expect.at("tdibm-c"), Outcome::kCorrect);
    EXPECT_TRUE(check_truth(find.value)) << to_json(find.value);
    EXPECT_TRUE(losses.insert(std::string(name_of(find.outcome)) + find.loss).second)
        << find.loss << " twice";
  }
  EXPECT_EQ(first.tally().inputs, raw.size());
  EXPECT_EQ(first.tally().failures, first.tally().known + finds.size());
  EXPECT_EQ(store.load().value().size(), finds.size());

  Triage again(store, quick_options());
  const std::vector<NamedCase> entries = store.load().value();
  for (const NamedCase& entry : entries) again.know(entry.value);
  EXPECT_THAT(triaged(again, raw), testing::IsEmpty());
  EXPECT_EQ(again.tally().failures, again.tally().known);
}

TEST(Triage, DecidesWhatComesWithoutTruth) {
  const ScratchFolder folder;
  Store store = Store::open(folder.path()).value();
  Triage triage(store, quick_options());
  std::vector<Case> raw = raw_finds();
  for (Case& c : raw) c.truth = {};
  EXPECT_GE(triaged(triage, raw).size(), 1U);
}

}  // namespace
}  // namespace ccdfuzz
