#include <fmt/format.h>
#include <gtest/gtest.h>

#include "ccd/robustness.hpp"
#include "meeting_points.hpp"
#include "method/method.hpp"

namespace ccdfuzz {
namespace {

/// The registered spec with its parameter, if it has one, made concrete.
std::string concrete(const std::string& spec) {
  const size_t parameter = spec.rfind(":F");
  return parameter == std::string::npos ? spec : spec.substr(0, parameter) + ":1e-12";
}

TEST(Registry, BadSpecsAreRefusedAndNamed) {
  std::vector<std::string> specs = {"", "nonsense", "TDIBM", " tdibm"};
  const auto behind = [&specs](const std::string& name, std::initializer_list<const char*> ends) {
    for (const char* end : ends) specs.push_back(name + end);
  };
  behind("trad", {":", ":obb", ":aabb:", ":aabb@unit-axes", "@unoptimised"});
  behind("tdibm", {" ", ":", ":1", "@fast", "@slip@slip", "@unoptimised@unoptimised"});
  behind("tdibm-e", {":1e-12", "@absolute"});
  behind("tdibm-c", {"@", "@unoptimised"});
  behind("tdibm-h", {"", ":", ":abc", ":-1", ":-0", ":+1", ":nan", ":inf", ":1e999", ":1e-12x"});
  behind("tdibm-h", {": 1e-12", ":1e-12:2", "-rel:1e-12", ":1e-12@count-pairs"});
  behind("tdibm-h", {"@absolute:1e-12"});
  for (const std::string& spec : specs) {
    const auto method = make_method(spec);
    ASSERT_FALSE(method) << spec;
    const std::string message = method.error().message();
    EXPECT_NE(message.find(fmt::format("\"{}\"", spec)), std::string::npos)
        << spec << " is not named in: " << message;
    EXPECT_FALSE(parse_method_list(fmt::format("tdibm,{}", spec))) << spec;
  }
}

/// Each switch is taken by the families that say so, alone and with all others, and still answers.
TEST(Registry, SwitchesAreTakenInAnyOrder) {
  for (const MethodInfo& info : registered_methods()) {
    std::string forth = concrete(info.spec), back = forth;
    for (const std::string& name : info.switches) {
      EXPECT_TRUE(make_method(fmt::format("{}@{}", concrete(info.spec), name))) << name;
      forth += "@" + name;
      back.insert(concrete(info.spec).size(), "@" + name);
    }
    for (const std::string& spec : {forth, back}) {
      const auto method = make_method(spec);
      ASSERT_TRUE(method) << method.error().message();
      const Answer answer = (*method)->answer(meeting_points(1), {});
      EXPECT_EQ(answer.verdict, Verdict::kHit) << spec;
      EXPECT_LE(answer.toi.value_or(2), 0.5) << spec;
      EXPECT_TRUE(make_tracer(spec)) << spec;
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

TEST(Registry, AnUnknownMethodNamesTheKnownOnes) {
  const std::string message = make_method("tdibm-x").error().message();
  for (const MethodInfo& info : registered_methods()) {
    EXPECT_NE(message.find(info.spec), std::string::npos) << message;
  }
}

TEST(PullApart, ReadsDecimalsHexFloatsAndPowersOfTwo) {
  for (const char* good : {"tdibm-h:0", "tdibm-h:.5", "tdibm-h:0x1p-40", "tdibm-h:2^-40"}) {
    EXPECT_TRUE(make_method(good)) << good;
  }
  for (const char* bad : {"tdibm-h:1e-400", "tdibm-h:1e400", "tdibm-h:0x-1", "tdibm-h:0x"}) {
    EXPECT_FALSE(make_method(bad)) << bad;
  }
}

TEST(MethodList, KeepsTheOrderAndRefusesDuplicates) {
  EXPECT_EQ(parse_method_list("tdibm-e,tdibm,tdibm-h:1e-8"),
            (std::vector<std::string>{"tdibm-e", "tdibm", "tdibm-h:1e-8"}));
  EXPECT_FALSE(parse_method_list("tdibm,tdibm"));
  EXPECT_FALSE(parse_method_list("tdibm,,tdibm-e"));
  EXPECT_FALSE(parse_method_list("tdibm,"));
}

}  // namespace
}  // namespace ccdfuzz
