#include "case/taxonomy.hpp"
#include "base/enum_names.hpp"

#include <gtest/gtest.h>

namespace ccdfuzz {
namespace {

TEST(Taxonomy, NamesAreOfOneClassOrKindEach) {
  for (const ContactClass contact : kContactClasses) {
    EXPECT_EQ(enum_named<ContactClass>(name_of(contact)), contact) << name_of(contact);
  }
  for (const CaseKind kind : kCaseKinds) {
    EXPECT_EQ(enum_named<CaseKind>(name_of(kind)), kind) << name_of(kind);
  }
  for (const char* none : {"", "vv", "VVV", "RP "}) {
    EXPECT_FALSE(enum_named<ContactClass>(none)) << none;
    EXPECT_FALSE(enum_named<CaseKind>(none)) << none;
  }
}

}  // namespace
}  // namespace ccdfuzz
