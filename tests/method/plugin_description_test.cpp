// What a plug-in may say of itself, by lines of JSON.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <map>
#include <string>

#include "method/plugin/line_protocol.hpp"

namespace ccdfuzz {
namespace {

TEST(PluginDescription, OfBodiesAreRefusedOfWhomTakesNone) {
  for (const std::string field :
       {"takes_turns", "takes_angles", "takes_spins", "plane", "bodies"}) {
    const std::string value = field == "bodies" ? R"([{"least_points":1}])" : "true";
    const std::string claim = R"({"protocol":1,")" + field + "\":" + value;
    const Fault refused = read_description(claim + '}').error();
    EXPECT_EQ(refused.name, kRefusal);
    EXPECT_EQ(refused.note, "claims " + field + " without takes_bodies");
    EXPECT_TRUE(read_description(claim + R"(,"takes_bodies":true})"));
  }
  EXPECT_TRUE(read_description(R"({"protocol":1,"takes_ends":true,"takes_meshes":true})"));
}

TEST(PluginDescription, AFaultInPlaceOfThemHasAName) {
  for (const auto& [line, name] : std::map<std::string, std::string>{
           {R"({"fault":"memory","message":"m"})", "memory"},
           {R"({"fault":""})", "garbage"},
           {R"({"fault":"refused"})", "garbage"},
           {R"({"fault":"number 17"})", "garbage"},
           {R"({"fault":3})", "garbage"},
           {R"({"fault":{}})", "garbage"},
       }) {
    EXPECT_EQ(read_description(line).error().name, name) << line;
    EXPECT_EQ(read_answer(line, 1, 1).error().name, name) << line;
  }
}

TEST(PluginDescription, AreRefusedWhenTheyCannotBeReadLackAnotherOrAreOfNoKnownField) {
  EXPECT_TRUE(read_description(R"({"protocol":1,"nan_policy":"hit","tolerance_kind":"space"})"));
  for (const char* claim :
       {R"("conservative":1)", R"("closed_t_max":"no")", R"("contact_at_zero":null)",
        R"("tolerance_kind":"parameter")", R"("tolerance_kind":0)", R"("tolerance":"small")",
        R"("tolerance":-1)", R"("tolerance":NaN)", R"("minimum_separation":-0.5)",
        R"("minimum_separation":Infinity)", R"("nan_policy":"miss")", R"("nan_policy":true)",
        R"("take_bodies":true)", R"("short_spins":true,"takes_bodies":true)",
        R"("initial_overlap":true,"ordinary":true)",
        R"("initial_overlap":true,"takes_bodies":true)",
        R"("initial_overlap":true,"ordinary":true,"takes_bodies":true,"contact_at_zero":false)"}) {
    const std::string line = fmt::format("{{\"protocol\":1,{}}}", claim);
    EXPECT_EQ(read_description(line).error().name, kRefusal) << claim;
  }
}

TEST(PluginDescription, AreRefusedWhereNoQueryIsOfTheirSize) {
  const auto accepting = [](const std::string& shape, auto degree) {
    return fmt::format(R"("accepts":[[{{"shape":"point"}},{{"shape":"{}","max_degree":{}}}]])",
                       shape, degree);
  };
  const auto refusal_of = [](const std::string& claim) {
    const auto read = read_description(fmt::format("{{\"protocol\":1,{}}}", claim));
    return read ? "" : read.error().note;
  };
  const std::string where = "its description: accepts[0][1].max_degree: ";
  EXPECT_EQ(refusal_of(accepting("triangle", 9)), where + "9 is outside 1..8");
  EXPECT_EQ(refusal_of(accepting("curve", 0)), where + "0 is outside 1..8");
  EXPECT_EQ(refusal_of(accepting("point", 9)), where + "9 is outside 0..8");
  EXPECT_EQ(refusal_of(accepting("hull", 82)), where + "82 is outside 1..81");
  EXPECT_EQ(refusal_of(accepting("hull", 1L << 32)), where + "4294967296 is outside 1..81");
  EXPECT_EQ(refusal_of(accepting("point", -1)), where + "-1 is outside 0..8");
  EXPECT_EQ(refusal_of(R"("within":1075)"), "its description: within: 1075 is outside 0..1074");
  for (const std::string& claim : {accepting("triangle", 8), accepting("hull", 81),
                                   accepting("point", 0), std::string(R"("within":1074)")}) {
    EXPECT_EQ(refusal_of(claim), "") << claim;
  }
}

}  // namespace
}  // namespace ccdfuzz
