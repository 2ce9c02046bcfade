#include <fmt/format.h>
#include <gtest/gtest.h>

#include "ccd/robustness.hpp"
#include "meeting_points.hpp"
#include "method/method.hpp"

namespace ccdfuzz {
namespace {

/// Each switch is taken by the families that say so, alone and with all others, and still answers.
TEST(Registry, SwitchesAreTakenInAnyOrder) {
  for (const MethodInfo& info : registered_methods()) {
    std::string forth = spec_of(info), back = forth;
    for (const std::string& name : info.switches) {
      EXPECT_TRUE(make_method(fmt::format("{}@{}", spec_of(info), name))) << name;
      forth += "@" + name;
      back.insert(spec_of(info).size(), "@" + name);
    }
    for (const std::string& spec : {forth, back}) {
      const auto method = make_method(spec);
      ASSERT_TRUE(method) << method.error().message();
      const Answer answer = (*method)->answer(meeting_points(1), {});
      EXPECT_EQ(answer.verdict, Verdict::kHit) << spec;
      EXPECT_LE(answer.toi.value_or(2), 0.5) << spec;
      EXPECT_TRUE((*method)->is_traceable()) << spec;
      EXPECT_EQ(method_info(spec)->spec, info.spec);
    }
  }
}

/// Three intercepts of 2^-40, 1 and 2^40: F of each, or F.
TEST(PullApart, IsAShareOfTheInterceptOrALength) {
  const PullApart share(0x1p-10), length(0x1p-10, PullUnit::kLength);
  EXPECT_EQ(share.pulled(0x1p40), 0x1p40 + 0x1p30);
  EXPECT_EQ(share.pulled(-0x1p-40), -0x1p-40 + 0x1p-50);
  EXPECT_EQ(length.pulled(1), 1 + 0x1p-10);
  EXPECT_EQ(length.pulled(0), 0x1p-10);
}

}  // namespace
}  // namespace ccdfuzz
