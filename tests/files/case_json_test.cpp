#include "files/case_json.hpp"

#include <gmock/gmock.h>

#include <bit>
#include <clocale>
#include <limits>

#include "base/verify.hpp"

namespace {

/// What the C library is made to say the decimal point is; null for what it really is. Locales
/// other than C need not be installed where the tests run.
const char* decimal_point = nullptr;

struct ForeignDecimalPoint {
  explicit ForeignDecimalPoint(const char* point) { decimal_point = point; }
  ~ForeignDecimalPoint() { decimal_point = nullptr; }
};

}  // namespace

/// Replaces the C library's, in all of the test program.
extern "C" lconv* localeconv() noexcept {
  static std::string point;
  static lconv said;
  point = decimal_point == nullptr ? "." : decimal_point;
  said.decimal_point = point.data();
  said.thousands_sep = said.grouping = point.data() + point.size();
  return &said;
}

namespace ccdfuzz {
namespace {

std::string number_case(const std::string& x) {
  return R"({"format":"ccdfuzz-case","version":1,"patches":[)"
         R"({"shape":"point","positions":[[)" +
         x +
         R"(,0,0]],"velocities":[[0,0,0]]},)"
         R"({"shape":"point","positions":[[0,0,0]],"velocities":[[0,0,0]]}],"t_max":1})";
}

double read_number(const std::string& x) {
  const auto parsed = parse_case(number_case(x), "c.json");
  if (!parsed) throw std::runtime_error(parsed.error().message());
  return parsed->query.patches[0].positions[0][0];
}

TEST(CaseJson, ReadsNumbersWithoutLoss) {
  const std::vector<std::pair<const char*, double>> table = {
      {"0", 0.0},
      {"-0", -0.0},
      {"-0.0", -0.0},
      {"-0e-999", -0.0},
      {"5e-324", 0x1p-1074},
      {"2.5e-324", 0x1p-1074},
      {"1.7976931348623157e308", 0x1.fffffffffffffp1023},
      {"9007199254740992", 0x1p53},
      {"9007199254740994", 0x1p53 + 2},
      {"-9223372036854775808", -0x1p63},
      {"18446744073709551616", 0x1p64},
      {"1267650600228229401496703205376", 0x1p100},
      {"9007199254740993.0", 0x1p53},  // a decimal fraction: to nearest even
      {"0.1", 0x1.999999999999ap-4},
      {"\"0x1.999999999999ap-4\"", 0.1},
      {"\"-0x0p+0\"", -0.0},
      {"\"0X.8P+1\"", 1.0},
      {"\"0x8.\"", 8.0},
      {"\"0x0.0000000000001p-1022\"", 0x1p-1074},
      {"\"0x10000000000000000000p-1080\"", 0x1p-1004},
      {"\"0x1.80000000000000000000\"", 1.5},
  };
  for (const auto& [text, value] : table) {
    EXPECT_EQ(std::bit_cast<std::uint64_t>(read_number(text)), std::bit_cast<std::uint64_t>(value))
        << text;
  }
}

TEST(CaseJson, ReadsAndWritesTheSameUnderEveryLocale) {
  for (const char* point : {",", "\u066b"}) {
    const ForeignDecimalPoint foreign(point);
    ASSERT_STREQ(std::localeconv()->decimal_point, point);
    const double tenth = read_number("0.1"), milli = read_number("1.5e-3");
    const std::string text = to_json(*parse_case(number_case("0.1"), "c.json"));
    EXPECT_EQ(tenth, 0.1) << point;
    EXPECT_EQ(milli, 1.5e-3) << point;
    EXPECT_THAT(text, testing::HasSubstr("[[0.1,0,0]]")) << point;
  }
}

TEST(CaseJson, WritesTheShortestTextInAFixedOrder) {
  Case c = *parse_case(number_case("0.10000000000000001"), "c.json");
  c.truth.collides = true;
  c.truth.witness = Witness{Rational(1, 3), {}};
  c.truth.clear_until = Rational(1, 4);
  c.origin.contact = "VV";
  c.origin.seed = 7;
  c.asked.precision = 0.25;
  c.expect["tdibm"] = Outcome::kLate;
  c.expect["trad"] = {Outcome::kMissed, "hull"};
  EXPECT_EQ(to_json(c),
            R"({"format":"ccdfuzz-case","version":2,"patches":[)"
            R"({"shape":"point","positions":[[0.1,0,0]],"velocities":[[0,0,0]]},)"
            R"({"shape":"point","positions":[[0,0,0]],"velocities":[[0,0,0]]}],"t_max":1,)"
            R"("truth":{"collides":true,"witness":{"t":"1/3","uv":[["0","0"],["0","0"]]},)"
            R"("clear_until":"1/4"},"origin":{"contact":"VV","seed":7},)"
            R"("asked":{"precision":0.25},"expect":{"tdibm":"late",)"
            R"("trad":{"outcome":"missed","cause":"hull"}}})");
}

TEST(CaseJson, CausesAreThoseThatFailuresHave) {
  const auto error_of = [](const Expected& expected) {
    Case c = *parse_case(number_case("1"), "c.json");
    c.expect["tdibm"] = expected;
    const auto read = parse_case(to_json(c), "c.json");
    return read ? "" : read.error().message();
  };
  EXPECT_EQ(error_of({Outcome::kMissed, "both roots"}), "");
  EXPECT_EQ(error_of({Outcome::kFalsePositive, "one-sided mesh"}), "");
  EXPECT_EQ(error_of({Outcome::kError, "exit 7"}), "");
  EXPECT_THAT(error_of({Outcome::kMissed, "Left root"}),
              testing::HasSubstr("expect.tdibm.cause: \"Left root\" is none of: hull, left root"));
  EXPECT_THAT(error_of({Outcome::kCorrect, "hull"}),
              testing::HasSubstr("\"hull\" stands beside an outcome that has no cause"));
}

TEST(CaseJson, VersionOneIsReadAndItsFurtherKeysAreCarriedOver) {
  std::string text = number_case("1");
  text.insert(text.rfind('}'),
              R"(,"origin":{"precision":1e-2,"label":7,"error of a":"hang",)"
              R"("loss of b":"level 3, axes 1-3, left root","loss of c":"level 0, hull",)"
              R"("loss of d":"level 0, hull","loss of e":"not traced"},)"
              R"("expect":{"a":"error","b":"missed","c":"late","d":"correct","e":"late"})");
  const auto old = parse_case(text, "c.json");
  ASSERT_TRUE(old) << old.error().message();
  EXPECT_EQ(old->asked, (Asked{.precision = 1e-2}));
  EXPECT_EQ(old->origin.more, (std::map<std::string, std::string>{{"label", "7"}}));
  EXPECT_EQ(old->expect, (std::map<std::string, Expected>{{"a", {Outcome::kError, "hang"}},
                                                          {"b", {Outcome::kMissed, "left root"}},
                                                          {"c", {Outcome::kLate, "hull"}},
                                                          {"d", Outcome::kCorrect},
                                                          {"e", Outcome::kLate}}));
  const auto again = parse_case(to_json(*old), "c.json");
  ASSERT_TRUE(again) << again.error().message();
  EXPECT_EQ(*again, *old);
}

TEST(CaseJson, RefusesToWriteWhatIsNotFinite) {
  Case c = *parse_case(number_case("1"), "c.json");
  c.query.t_max = std::numeric_limits<double>::infinity();
  EXPECT_THROW(to_json(c), InternalError);
}

}  // namespace
}  // namespace ccdfuzz
