#include "io/fields.hpp"

#include <gtest/gtest.h>

namespace ccdfuzz {
namespace {

enum class Colour { kRed, kBlue };
constexpr std::array kColours = {Colour::kRed, Colour::kBlue};
constexpr const auto& all_of(Colour) {
  return kColours;
}
std::string_view name_of(Colour colour) {
  return colour == Colour::kRed ? "red" : "blue";
}

struct Inner {
  int level = 0;
  Colour colour = Colour::kRed;

  static void fields(auto& archive, auto& inner) {
    archive("level", inner.level, Within{0, 9});
    archive("colour", inner.colour);
  }
  friend bool operator==(const Inner&, const Inner&) = default;
};

struct Outer {
  std::string name;
  std::uint64_t count = 0;
  double real = 0;
  bool flag = false;
  std::optional<double> maybe;
  std::optional<std::string> note;
  std::vector<int> numbers;
  std::array<double, 2> pair{};
  std::map<std::string, Colour> colours;
  Inner inner;

  static void fields(auto& archive, auto& outer) {
    archive.format("test", 1, 2);
    archive("name", outer.name);
    archive("count", outer.count);
    archive("real", outer.real, positive);
    archive("flag", outer.flag);
    archive("maybe", outer.maybe);
    archive.optional("note", outer.note);
    archive("numbers", outer.numbers, Each{Within{-5, 5}});
    archive("pair", outer.pair);
    archive.optional("colours", outer.colours);
    archive("inner", outer.inner);
  }
  friend bool operator==(const Outer&, const Outer&) = default;
};

const Outer kFull = {.name = "a \"b\", c",
                     .count = ~std::uint64_t{0},
                     .real = 0x1.fffffffffffffp-1,
                     .flag = true,
                     .maybe = 0x1p-1074,
                     .note = "n",
                     .numbers = {1, -2},
                     .pair = {0, -1.5},
                     .colours = {{"x", Colour::kBlue}},
                     .inner = {3, Colour::kBlue}};

constexpr const char* kFullJson =
    R"({"format":"test","version":2,"name":"a \"b\", c","count":18446744073709551615,)"
    R"("real":0.9999999999999999,"flag":true,"maybe":5e-324,"note":"n","numbers":[1,-2],)"
    R"("pair":[0,-1.5],"colours":{"x":"blue"},"inner":{"level":3,"colour":"blue"}})";

TEST(Fields, AreWrittenAsJsonInTheirOrder) {
  EXPECT_EQ(to_json(kFull), kFullJson);
}

TEST(Fields, ReadBackWhatWasWritten) {
  Outer sparse;
  sparse.real = 1;
  for (const Outer& outer : {kFull, sparse}) {
    const auto read = from_json<Outer>(to_json(outer), "f");
    ASSERT_TRUE(read) << read.error().message();
    EXPECT_EQ(*read, outer);
    const auto laid_out = from_json<Outer>(readable_json(to_json(outer)), "f");
    ASSERT_TRUE(laid_out) << laid_out.error().message();
    EXPECT_EQ(*laid_out, outer);
  }
}

TEST(Fields, RefuseWhatIsNotAsAsked) {
  struct Row {
    std::string from, to, message;
  };
  for (const auto& [from, to, message] : std::vector<Row>{
           {R"("test")", R"("tost")", R"(f: format: "tost" is not "test")"},
           {R"("version":2)", R"("version":3)",
            "f: version: 3 is not a version that this program reads (1 to 2)"},
           {R"("flag":true,)", "", "f: flag: missing"},
           {R"("flag":true)", R"("flag":1)", "f: flag: 1 is not true or false"},
           {R"("level":3)", R"("level":10)", "f: inner.level: 10 is outside 0..9"},
           {R"("level":3)", R"("level":3,"depth":1)",
            "f: inner.depth: unknown key (known here: level, colour)"},
           {R"("colour":"blue")", R"("colour":"green")",
            R"(f: inner.colour: "green" is none of red, blue)"},
           {"[1,-2]", "[1,-6]", "f: numbers[1]: -6 is outside -5..5"},
           {"[1,-2]", "[1,2.5]", "f: numbers[1]: 2.5 is not an integer"},
           {"[0,-1.5]", "[0]", "f: pair: needs 2 items, not 1"},
           {R"("x":"blue")", R"("x":7)", "f: colours.x: 7 is not a string"},
           {"0.9999999999999999", "0", "f: real: 0 is not > 0"},
           {"0.9999999999999999", "0.99999999999999990001",
            "f: real: 0.99999999999999990001 is no double, and has more than the 17 digits that "
            "tell doubles apart; the nearest is 0.9999999999999999"},
           {"18446744073709551615", "18446744073709551616",
            "f: count: 18446744073709551616 is outside 0..18446744073709551615"}}) {
    std::string json = kFullJson;
    const size_t at = json.find(from);
    ASSERT_NE(at, std::string::npos) << from;
    json.replace(at, from.size(), to);
    const auto read = from_json<Outer>(json, "f");
    ASSERT_FALSE(read) << json;
    EXPECT_EQ(read.error().message(), message);
  }
}

TEST(Fields, MayIgnoreWhatTheyDoNotKnow) {
  const auto read =
      from_json<Inner>(R"({"level":1,"more":[],"colour":"red"})", "f", Unknown::kIgnore);
  ASSERT_TRUE(read) << read.error().message();
  EXPECT_EQ(read->level, 1);
}

TEST(ReadableJson, BreaksLinesOfOver100ColumnsAtTheirMembers) {
  const std::string long_text(60, 'x');
  const std::string json = R"({"short":[1,{"a":"b,]"}],"long":[")" + long_text + R"(",")" +
                           long_text + R"("],"end":{}})";
  EXPECT_EQ(readable_json(json), "{\n  \"short\": [1, {\"a\": \"b,]\"}],\n  \"long\": [\n    \"" +
                                     long_text + "\",\n    \"" + long_text +
                                     "\"\n  ],\n  \"end\": {}\n}");
}

}  // namespace
}  // namespace ccdfuzz
