#include "query/taxonomy.hpp"

#include <gtest/gtest.h>

namespace ccdfuzz {
namespace {

TEST(Taxonomy, NamesAreOfOneClassOrKindEach) {
  for (const ContactClass contact : kContactClasses) {
    EXPECT_EQ(contact_class_named(name_of(contact)), contact) << name_of(contact);
  }
  for (const CaseKind kind : kCaseKinds) {
    EXPECT_EQ(case_kind_named(name_of(kind)), kind) << name_of(kind);
  }
  for (const char* none : {"", "vv", "VVV", "RP "}) {
    EXPECT_FALSE(contact_class_named(none)) << none;
    EXPECT_FALSE(case_kind_named(none)) << none;
  }
}

}  // namespace
}  // namespace ccdfuzz
