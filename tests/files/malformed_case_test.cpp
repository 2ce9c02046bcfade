#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <vector>

#include "files/case_json.hpp"

namespace ccdfuzz {
namespace {

/// A good case, of which each row of the table spoils one spot. What is refused of every field
/// alike is in tests/io/fields_test.cpp, and what is refused of loops in
/// tests/bezier/trim_test.cpp.
constexpr std::string_view kGood = R"({
  "format": "ccdfuzz-case", "version": 2,
  "patches": [
    {"shape": "triangle", "degree": 1, "positions": [[0,0,0],[1,0,0],[0,1,0]],
     "velocities": [[0,0,1],[0,0,1],[0,0,1]]},
    {"shape": "tensor", "degree": [1, 1],
     "positions": [[0,0,1],[0,1,1],[1,0,1],[1,1,1.5]],
     "velocities": [[0,0,0],[0,0,0],[0,0,0],[0,0,"0x0p+0"]]}
  ],
  "t_max": 2.0,
  "truth": {"collides": true,
            "witness": {"t": "1", "uv": [["0","0"], ["0","0"]]},
            "clear_until": "1/2",
            "certificate": {
              "contact": {"centre": [0.25, 0.5, 0, 0, 1], "dependent": [1, 0], "varied": [0, 1, 4],
                          "radius": [0.125, 0.0625, 1e-3],
                          "inverse": [[1, 0, 0], [0, 1, 0], [0, 0, -2]]},
              "clear": {"kind": "T", "until": "3/4",
                        "tree": {"offset": 12, "length": 34,
                                 "xxh3": "0123456789abcdef0123456789abcdef"}}}},
  "origin": {"contact": "VV", "kind": "RP", "generator": "by hand", "seed": 7, "label": 1e-2},
  "asked": {"precision": 1e-2, "max_pops": 5},
  "expect": {"tdibm": "missed", "tdibm-h:1e-12": "correct"}
})";

struct Row {
  const char* name;
  const char* from;  ///< the text in kGood to replace; "" for all of it
  const char* to;
  const char*
      message;  ///< without "c.json: "; all of it, but of what the JSON library says the place
};

void PrintTo(const Row& row, std::ostream* out) {
  *out << row.name;
}

const std::vector<Row> kTable = {
    // Not JSON.
    {"Empty", "", "", "is empty; JSON is accepted"},
    {"Blank", "", " \r\n\t ", "is empty; JSON is accepted"},
    {"Array", "", "[]", "an array is not an object"},
    {"Unclosed", "", "{\"format\": \"ccdfuzz-case\"", "column 26: "},
    {"TrailingGarbage", "\"correct\"}\n}", "\"correct\"}\n} x", "line 24, column 3: "},
    {"TrailingComma", "\"t_max\": 2.0,", "\"t_max\": 2.0,,", "line 10, column 16: "},
    {"Comment", "\"t_max\": 2.0,", "// no\n", "line 10, column 3: "},
    {"NanLiteral", "1.5]", "NaN]", "line 7, column 49: "},
    {"LeadingZero", "1.5]", "01.5]", "line 7, column 52: "},
    {"DecimalComma", "1.5]", "1,5]", "patches[1].positions[3]: needs 3 coordinates, not 4"},
    {"HexNumber", "1.5]", "0x1p0]", "line 7, column 50: "},
    {"DuplicateTopKey", "\"t_max\": 2.0,", "\"t_max\": 2.0, \"t_max\": 1,", "t_max: duplicate key"},
    {"DuplicateTruthKey", "\"clear_until\"", "\"collides\"", "truth.collides: duplicate key"},
    {"DuplicateMethod", "\"tdibm\"", "\"tdibm-h:1e-12\"",
     "expect[\"tdibm-h:1e-12\"]: duplicate key"},
    {"DuplicateByEscape", "\"kind\": \"RP\"", "\"\\u0073eed\": 7", "origin.seed: duplicate key"},
    // Keys.
    {"NoFormat", "\"format\": \"ccdfuzz-case\",", "", "format: missing"},
    {"NoVersion", "\"version\": 2,", "", "version: missing"},
    {"NoPatches", "\"patches\"", "\"patchs\"", "patches: missing"},
    {"NoTMax", "\"t_max\": 2.0,", "", "t_max: missing"},
    {"NoShape", "\"shape\": \"triangle\",", "", "patches[0].shape: missing"},
    {"NoDegree", "\"degree\": 1,", "", "patches[0].degree: missing"},
    {"NoVelocities", "\"velocities\": [[0,0,0]", "\"velocity\": [[0,0,0]",
     "patches[1].velocities: missing"},
    {"UnknownTruthKey", "\"clear_until\"", "\"clear until\"",
     "truth[\"clear until\"]: unknown key (known here: collides, witness, clear_until, proof, "
     "certificate)"},
    {"NoWitnessTime", "{\"t\": \"1\", ", "{", "truth.witness.t: missing"},
    {"NoWitnessParameters", ", \"uv\": [[\"0\",\"0\"], [\"0\",\"0\"]]", "",
     "truth.witness.uv: missing"},
    // Format and version.
    {"OtherFormat", "ccdfuzz-case", "ccdfuzz", "format: \"ccdfuzz\" is not \"ccdfuzz-case\""},
    {"LaterVersion", "\"version\": 2", "\"version\": 3",
     "version: 3 is not a version that this program reads (1 to 2)"},
    {"VersionNought", "\"version\": 2", "\"version\": 0",
     "version: 0 is not a version that this program reads (1 to 2)"},
    {"HullOfManyVelocities", "\"triangle\", \"degree\": 1", "\"hull\"",
     "patches[0].velocities: has 3 velocities; a hull has 1"},
    {"HullBesideATensor",
     "\"triangle\", \"degree\": 1, \"positions\": [[0,0,0],[1,0,0],[0,1,0]],\n     "
     "\"velocities\": [[0,0,1],[0,0,1],[0,0,1]]",
     "\"hull\", \"positions\": [[0,0,0]], \"velocities\": [[0,0,1]]",
     "patches[0].shape: hull stands beside a tensor; both patches are hulls, or none"},
    {"EndsBesideVelocities", "\"degree\": 1,", "\"degree\": 1, \"ends\": [],",
     "patches[0].ends: stands beside velocities; a patch has one of them"},
    {"EndsPastOne", "\"velocities\": [[0,0,0]", "\"ends\": [[0,0,0]",
     "t_max: 2.0 is past 1, where the ends of a patch are"},
    {"NegativeSeparation", "\"t_max\"", "\"separation\": -1, \"t_max\"",
     "separation: -1 is negative"},
    // What later versions will have.
    {"NoLoop", "\"degree\": 1,", "\"degree\": 1, \"trim\": [],",
     "patches[0].trim: has no loop; a patch that is whole has no such key"},
    {"LoopOfTwoVertices", "\"degree\": 1,", "\"degree\": 1, \"trim\": [[[0, 0], [1, 0]]],",
     "patches[0].trim[0]: has 2 vertices, and needs 3"},
    {"VertexOfThree", "\"degree\": 1,", "\"degree\": 1, \"trim\": [[[0, 0], [1, 0], [0, 1, 0]]],",
     "patches[0].trim[0][2]: needs 2 items, not 3"},
    {"NoWeights", "\"degree\": 1,", "\"degree\": 1, \"weights\": [],",
     "patches[0].weights: has 0 weights of 3 control points"},
    {"WeightOfZero", "\"degree\": 1,", "\"degree\": 1, \"weights\": [1, 0, 1],",
     "patches[0].weights[1]: 0 is not > 0"},
    {"WeightsTooFarApart", "\"degree\": 1,", "\"degree\": 1, \"weights\": [1, \"0x1p+61\", 1],",
     "patches[0].weights: has binary exponents that differ by more than 60"},
    {"Bodies", "\"patches\"", "\"bodies\"", "bodies: is not yet supported by this version"},
    // Patches.
    {"PatchesOfWrongType", "", R"({"format":"ccdfuzz-case","version":1,"patches":{},"t_max":1})",
     "patches: an object is not an array"},
    {"NoPatch", "", R"({"format":"ccdfuzz-case","version":1,"patches":[],"t_max":1})",
     "patches: needs 2 items, not 0"},
    {"UnknownShape", "\"triangle\"", "\"tetrahedron\"",
     "patches[0].shape: \"tetrahedron\" is none of point, curve, triangle, tensor, hull"},
    {"DegreeZero", "\"degree\": 1,", "\"degree\": 0,", "patches[0].degree: 0 is outside 1..8"},
    {"DegreeNine", "\"degree\": 1,", "\"degree\": 9,", "patches[0].degree: 9 is outside 1..8"},
    {"DegreeArrayForTriangle", "\"degree\": 1,", "\"degree\": [1, 1],",
     "patches[0].degree: an array is not an integer"},
    {"DegreeNumberForTensor", "[1, 1],\n", "1,\n", "patches[1].degree: 1 is not an array"},
    {"DegreeNineInTensor", "[1, 1],\n", "[1, 9],\n", "patches[1].degree[1]: 9 is outside 1..8"},
    {"TooFewPoints", "[1,0,0],[0,1,0]]", "[1,0,0]]",
     "patches[0].positions: has 2 control points; triangle(1) has 3"},
    {"TooManyVelocities", "[0,0,1],[0,0,1],[0,0,1]]", "[0,0,1],[0,0,1],[0,0,1],[0,0,1]]",
     "patches[0].velocities: has 4 control points; triangle(1) has 3"},
    {"PointOfWrongType", "[1,0,0]", "1", "patches[0].positions[1]: 1 is not an array"},
    {"TwoCoordinates", "[1,0,0]", "[1,0]", "patches[0].positions[1]: needs 3 coordinates, not 2"},
    // Reals.
    {"CoordinateNull", "1.5]", "null]", "patches[1].positions[3][2]: null is not a number"},
    {"TooLarge", "1.5]", "1e400]",
     "patches[1].positions[3][2]: 1e400 is out of the range of a double"},
    {"TooLargeByOneDigit", "1.5]", "-1.7976931348623159e308]",
     "patches[1].positions[3][2]: -1.7976931348623159e308 is out of the range of a double"},
    {"TooSmall", "1.5]", "1e-400]",
     "patches[1].positions[3][2]: 1e-400 is out of the range of a double"},
    {"InexactInteger", "1.5]", "9007199254740993]",
     "patches[1].positions[3][2]: 9007199254740993 is an integer that no double equals"},
    {"InexactHugeInteger", "1.5]", "36893488147419103233]",
     "patches[1].positions[3][2]: 36893488147419103233 is an integer that no double equals"},
    {"LongDecimal", "\"t_max\": 2.0", "\"t_max\": 0.9999999999999999999999",
     "t_max: 0.9999999999999999999999 is no double, and has more than the 17 digits that tell "
     "doubles apart; the nearest is 1"},
    {"NanText", "1.5]", "\"nan\"]", "patches[1].positions[3][2]: \"nan\" is not finite"},
    {"InfinityText", "1.5]", "\"-Infinity\"]",
     "patches[1].positions[3][2]: \"-Infinity\" is not finite"},
    {"DecimalText", "1.5]", "\"1.5\"]",
     "patches[1].positions[3][2]: \"1.5\" is not a hex float such as \"0x1.8p-3\""},
    {"HexWithoutDigits", "1.5]", "\"0xp1\"]",
     "patches[1].positions[3][2]: \"0xp1\" is not a hex float such as \"0x1.8p-3\""},
    {"HexWithTwoPoints", "1.5]", "\"0x1.8.8p1\"]",
     "patches[1].positions[3][2]: \"0x1.8.8p1\" is not a hex float such as \"0x1.8p-3\""},
    {"HexWithoutExponent", "1.5]", "\"0x1p\"]",
     "patches[1].positions[3][2]: \"0x1p\" is not a hex float such as \"0x1.8p-3\""},
    {"HexWithTwoSigns", "1.5]", "\"0x1p+-1\"]",
     "patches[1].positions[3][2]: \"0x1p+-1\" is not a hex float such as \"0x1.8p-3\""},
    {"HexWithSpace", "1.5]", "\"0x1p1 \"]",
     "patches[1].positions[3][2]: \"0x1p1 \" is not a hex float such as \"0x1.8p-3\""},
    {"HexTooLarge", "1.5]", "\"0x1p1024\"]",
     "patches[1].positions[3][2]: \"0x1p1024\" is not exactly a double"},
    {"HexTooFine", "1.5]", "\"0x1.00000000000008p0\"]",
     "patches[1].positions[3][2]: \"0x1.00000000000008p0\" is not exactly a double"},
    {"HexBelowSubnormal", "1.5]", "\"0x1p-1075\"]",
     "patches[1].positions[3][2]: \"0x1p-1075\" is not exactly a double"},
    {"HexWithAbsurdExponent", "1.5]", "\"0x1p99999999999999999999\"]",
     "patches[1].positions[3][2]: \"0x1p99999999999999999999\" is out of the range of a double"},
    {"TMaxNegative", "\"t_max\": 2.0", "\"t_max\": -1e-320", "t_max: -1e-320 is negative"},
    // Truth.
    {"TruthOfWrongType", "{\"contact\": \"VV\"", "{\"truth\": {}, \"contact\": \"VV\"",
     "origin.truth: an object is neither a string nor a number"},
    {"CollidesAsText", "\"collides\": true", "\"collides\": \"yes\"",
     "truth.collides: \"yes\" is not true or false"},
    {"NoWitness", "",
     R"({"format":"ccdfuzz-case","version":1,"patches":[
         {"shape":"point","positions":[[0,0,0]],"velocities":[[0,0,0]]},
         {"shape":"point","positions":[[0,0,0]],"velocities":[[0,0,0]]}],
         "t_max":1,"truth":{"collides":true}})",
     "truth.witness: missing, though collides is true"},
    // Certificates.
    {"CertificateOfWrongType", "\"origin\"", "\"certificate\": 1, \"origin\"",
     "certificate: unknown key (known here: format, version, patches, t_max, separation, truth, "
     "origin, "
     "asked, expect)"},
    {"UnknownCertificate", "\"contact\": {", "\"hit\": {",
     "truth.certificate.hit: unknown key (known here: contact, root, clear)"},
    {"FractionInARoot", "\"contact\": {",
     "\"root\": {\"polynomial\": [\"-1\", \"1/2\"], \"from\": \"0\", \"by\": \"1\"}, \"contact\": "
     "{",
     "truth.certificate.root.polynomial[1]: \"1/2\" is not a whole number"},
    {"RootWithoutEnd", "\"contact\": {",
     "\"root\": {\"polynomial\": [\"-1\", \"2\"], \"from\": \"0\"}, \"contact\": {",
     "truth.certificate.root.by: missing"},
    {"FourUnknowns", "[0.25, 0.5, 0, 0, 1]", "[0.25, 0.5, 0, 1]",
     "truth.certificate.contact.centre: needs 5 items, not 4"},
    {"CentreNotFinite", "[0.25,", "[\"nan\",",
     "truth.certificate.contact.centre[0]: \"nan\" is not finite"},
    {"DependentThree", "\"dependent\": [1, 0]", "\"dependent\": [3, 0]",
     "truth.certificate.contact.dependent[0]: 3 is outside 0..2"},
    {"VariedFive", "[0, 1, 4]", "[0, 1, 5]",
     "truth.certificate.contact.varied[2]: 5 is outside 0..4"},
    {"VariedTwice", "[0, 1, 4]", "[0, 4, 4]", "truth.certificate.contact.varied: is not ascending"},
    {"RadiusZero", "0.0625", "0", "truth.certificate.contact.radius[1]: 0 is not > 0"},
    {"TwoColumns", "[0, 0, -2]", "[0, 0]",
     "truth.certificate.contact.inverse[2]: needs 3 items, not 2"},
    {"UnknownClearance", "\"kind\": \"T\"", "\"kind\": \"Q\"",
     "truth.certificate.clear.kind: \"Q\" is not a certificate of absence (P, T, L, K, N, F)"},
    {"LinearWithATree", "\"kind\": \"T\"", "\"kind\": \"L\"",
     "truth.certificate.clear.closed: missing"},
    {"PlaneWithATree", "\"kind\": \"T\"", "\"kind\": \"P\"",
     "truth.certificate.clear.normal: missing"},
    {"NoTree", "\"tree\": {\"offset\"", "\"trees\": {\"offset\"",
     "truth.certificate.clear.tree: missing"},
    {"UntilAsNumber", "\"3/4\"", "0.75",
     "truth.certificate.clear.until: 0.75 is not a string \"p\" or \"p/q\""},
    {"NegativeOffset", "\"offset\": 12", "\"offset\": -12",
     "truth.certificate.clear.tree.offset: -12 is outside 0..18446744073709551615"},
    {"EmptyTree", "\"length\": 34", "\"length\": 0",
     "truth.certificate.clear.tree.length: 0 is outside 1..4611686018427387904"},
    {"ShortHash", "0123456789abcdef0123", "123456789abcdef0123",
     "truth.certificate.clear.tree.xxh3: \"123456789abcdef0123456789abcdef\" is not 32 lower-case "
     "hexadecimal digits"},
    {"ProofWithoutItsCertificate", "\"collides\": true", "\"proof\": \"P\", \"collides\": true",
     "truth.proof: \"P\" has no certificate.clear of that kind"},
    {"NoProof", "\"collides\": true", "\"collides\": false",
     "truth.proof: missing, though collides is false"},
    {"UnknownProof", "\"collides\": true", "\"proof\": \"trust me\", \"collides\": false",
     "truth.proof: \"trust me\" is not a proof (P, T, rational-tdibm, L, K, N, F)"},
    {"WitnessTimeAsNumber", "\"t\": \"1\"", "\"t\": 1",
     "truth.witness.t: 1 is not a string \"p\" or \"p/q\""},
    {"WitnessTimeDecimal", "\"t\": \"1\"", "\"t\": \"0.5\"",
     "truth.witness.t: \"0.5\" is not a rational \"p\" or \"p/q\" with q > 0"},
    {"ClearUntilOverZero", "\"1/2\"", "\"1/0\"",
     "truth.clear_until: \"1/0\" is not a rational \"p\" or \"p/q\" with q > 0"},
    {"ClearUntilOverNegative", "\"1/2\"", "\"1/-2\"",
     "truth.clear_until: \"1/-2\" is not a rational \"p\" or \"p/q\" with q > 0"},
    {"OneParameterPair", "[[\"0\",\"0\"], [\"0\",\"0\"]]", "[[\"0\",\"0\"]]",
     "truth.witness.uv: needs 2 items, not 1"},
    {"ParameterEmpty", "[\"0\",\"0\"]]", "[\"0\",\"\"]]",
     "truth.witness.uv[1][1]: \"\" is not a rational \"p\" or \"p/q\" with q > 0"},
    // Origin and expectations.
    {"ContactAsNumber", "\"VV\"", "1", "origin.contact: 1 is not a string"},
    {"SeedTooLarge", "\"seed\": 7", "\"seed\": 18446744073709551616",
     "origin.seed: 18446744073709551616 is outside 0..18446744073709551615"},
    {"OriginHoldsBool", "1e-2", "true", "origin.label: true is neither a string nor a number"},
    {"ExpectOfWrongType", "{\"tdibm\": \"missed\", \"tdibm-h:1e-12\": \"correct\"}", "\"missed\"",
     "expect: \"missed\" is not an object"},
    {"UnknownOutcome", "\"missed\"", "\"wrong\"",
     "expect.tdibm: \"wrong\" is none of correct, missed, late, false_positive, undecided, "
     "unknown, error, not_asked"},
    {"OutcomeInCapitals", "\"correct\"", "\"Correct\"",
     "expect[\"tdibm-h:1e-12\"]: \"Correct\" is none of correct, missed, late, false_positive, "
     "undecided, unknown, error, not_asked"},
    {"NoOutcome", "\"missed\"", "{\"cause\": \"hull\"}", "expect.tdibm.outcome: missing"},
    {"NoCause", "\"missed\"", "{\"outcome\": \"late\"}", "expect.tdibm.cause: missing"},
    {"AskedInVersionOne", "\"version\": 2", "\"version\": 1",
     "asked: unknown key (known here: format, version, patches, t_max, separation, truth, origin, "
     "expect)"},
    {"AskedOfWrongType", "{\"precision\": 1e-2, \"max_pops\": 5}", "5",
     "asked: 5 is not an object"},
    {"PrecisionZero", "{\"precision\": 1e-2", "{\"precision\": 0",
     "asked.precision: 0 is not in [2^-50, 1]"},
    {"PrecisionTwo", "{\"precision\": 1e-2", "{\"precision\": 2",
     "asked.precision: 2 is not in [2^-50, 1]"},
    {"NoPops", "\"max_pops\": 5", "\"max_pops\": 0",
     "asked.max_pops: 0 is outside 1..18446744073709551615"},
};

class MalformedCase : public testing::TestWithParam<Row> {};
INSTANTIATE_TEST_SUITE_P(Table, MalformedCase, testing::ValuesIn(kTable),
                         [](const auto& row) { return std::string(row.param.name); });

std::string spoiled(const Row& row) {
  std::string text(kGood);
  if (*row.from == '\0') return row.to;
  const size_t at = text.find(row.from);
  if (at == std::string::npos) throw std::logic_error(std::string(row.from) + " is not in kGood");
  return text.replace(at, std::string_view(row.from).size(), row.to);
}

TEST_P(MalformedCase, IsRefusedByFilePathAndValue) {
  const auto parsed = parse_case(spoiled(GetParam()), "c.json");
  ASSERT_FALSE(parsed);
  const std::string told = parsed.error().message(), message = GetParam().message;
  const bool is_whole = !message.ends_with(": ");
  EXPECT_EQ(is_whole ? told : told.substr(0, 8 + message.size()), "c.json: " + message) << told;
}

TEST(MalformedCase, TheTableSpoilsAGoodCase) {
  const auto parsed = parse_case(kGood, "c.json");
  ASSERT_TRUE(parsed) << parsed.error().message();
  EXPECT_EQ(parsed->origin.more.at("label"), "1e-2");
  EXPECT_EQ(parsed->asked, (Asked{1e-2, 5}));
  EXPECT_GE(kTable.size(), 60U);
}

TEST(MalformedCase, ByteOutsideUtf8IsNamed) {
  std::string text(kGood);
  text.replace(text.find("by hand"), 7, "by \xff");
  const auto parsed = parse_case(text, "c.json");
  ASSERT_FALSE(parsed);
  EXPECT_THAT(parsed.error().message(),
              testing::AllOf(testing::StartsWith("c.json: line 21, column "),
                             testing::HasSubstr("ill-formed UTF-8")));
}

TEST(MalformedCase, AnOverlongIntegerIsNotEchoedWhole) {
  std::string text(kGood);
  text.replace(text.find("1.5]"), 3, std::string(800'000, '9'));
  EXPECT_EQ(parse_case(text, "c.json").error().message(),
            "c.json: patches[1].positions[3][2]: " + std::string(60, '9') +
                "… is out of the range of a double");
}

TEST(MalformedCase, NestingAndKeysAreBounded) {
  const std::string deep(1'000'000, '[');
  EXPECT_EQ(parse_case(deep, "c.json").error().message(), "c.json: nested deeper than 64 levels");
  std::string wide = "{\"origin\": {";
  for (int i = 0; i < 100'000; ++i) wide += "\"k" + std::to_string(i) + "\":1,";
  wide += "\"k\":1}}";
  EXPECT_EQ(parse_case(wide, "c.json").error().message(), "c.json: origin: more than 1024 keys");
}

}  // namespace
}  // namespace ccdfuzz
