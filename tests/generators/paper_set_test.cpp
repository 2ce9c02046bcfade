#include "generators/paper_set.hpp"

#include <gtest/gtest.h>

#include <map>

#include "certify/checker/check_truth.hpp"
#include "share.hpp"

namespace ccdfuzz {
namespace {

TEST(PaperSet, HasTheCountsOfTable4) {
  std::map<CaseKind, std::uint64_t> counts;
  for (const PaperItem& item : paper_items()) ++counts[item.kind];
  EXPECT_EQ(counts[CaseKind::kRP], 11023U);
  EXPECT_EQ(counts[CaseKind::kNHP], 1100U);
  EXPECT_EQ(counts[CaseKind::kNMN], 1100U);
  EXPECT_EQ(2 * counts[CaseKind::kRP] + counts[CaseKind::kNHP] + counts[CaseKind::kNMN], 24246U);
}

TEST(PaperSet, APartHasEveryClassAndKind) {
  std::map<std::pair<ContactClass, CaseKind>, std::uint64_t> counts;
  for (const PaperItem& item : paper_items(1000)) ++counts[{item.contact, item.kind}];
  EXPECT_EQ(counts.size(), 18U);
  EXPECT_EQ((counts[{ContactClass::kFF, CaseKind::kRP}]), 7U);
  EXPECT_EQ((counts[{ContactClass::kVV, CaseKind::kNMN}]), 1U);
  EXPECT_EQ(paper_items(~std::uint64_t{0}).size(), 18U) << "one of each";
}

TEST(PaperSet, NegativesAreThoseThatGenerateMakes) {
  for (const ContactClass contact : kContactClasses) {
    for (std::uint64_t i = 0; i < 8 / std::min<std::uint64_t>(kOneIn, 8); ++i) {
      GeneratorOptions options{.contact = contact, .seed = 3};
      const PaperCases made = make_paper_cases({contact, CaseKind::kRP, i}, 3);
      ASSERT_EQ(made.cases.size(), 2U);
      EXPECT_EQ(made.cases[0], generate(options, i).value);
      options.kind = CaseKind::kRN;
      EXPECT_EQ(made.cases[1], generate(options, i).value);
    }
  }
}

TEST(PaperSet, NearMissesHaveACertificate) {
  for (const ContactClass contact : kContactClasses) {
    const PaperCases made = make_paper_cases({contact, CaseKind::kNMN, 1}, 0);
    const Case& miss = made.cases.at(0);
    ASSERT_TRUE(miss.truth.clearance);
    auto tree = std::get<MissTree>(*miss.truth.clearance);
    EXPECT_TRUE(check_clearance(miss.query, tree)) << name_of(contact);
    // One of a tree that was cut off is refused.
    tree.tree.bytes.resize(tree.tree.bytes.size() / 2);
    EXPECT_FALSE(check_clearance(miss.query, tree));
  }
}

}  // namespace
}  // namespace ccdfuzz
