#include "allocations.hpp"

#include <gtest/gtest.h>

#include "generators/generate.hpp"
#include "method/method.hpp"

namespace ccdfuzz {
namespace {

TEST(Method, AllocatesNothingOnceWarm) {
  std::vector<Query> queries;
  for (const ContactClass contact : kContactClasses) {
    for (const CaseKind kind : {CaseKind::kRP, CaseKind::kRN}) {
      GeneratorOptions options{
          .contact = contact, .kind = kind, .construction = Construction::kOneSided};
      queries.push_back(generate(options, 0).value.query);
    }
  }
  SearchOptions options;
  options.precision = 0x1p-7;
  for (const char* spec : {"tdibm", "tdibm-h:1e-12", "tdibm-h:1e-12@absolute@unit-axes", "tdibm-e",
                           "tdibm-e-literal", "tdibm-c"}) {
    const auto method = make_method(spec);
    ASSERT_TRUE(method) << spec;
    const auto answer_all = [&] {
      int decided = 0;
      for (const Query& query : queries) {
        decided += (*method)->answer(query, options).verdict != Verdict::kUndecided ? 1 : 0;
      }
      return decided;
    };
    answer_all();
    const long before = allocations();
    const int decided = answer_all();
    EXPECT_EQ(allocations() - before, 0) << spec;
    EXPECT_EQ(decided, static_cast<int>(queries.size())) << spec;
  }
  EXPECT_GT(allocations(), 0) << "the counter counts";
}

}  // namespace
}  // namespace ccdfuzz
