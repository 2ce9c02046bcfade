#include <gtest/gtest.h>

#include <vector>

#include "files/case_json.hpp"

namespace ccdfuzz {
namespace {

/// What two bodies have beside their positions and velocities, and what is wrong with it.
struct Bodies {
  const char* name;
  const char* first;
  const char* second;
  const char* message;  ///< without "c.json: "; "": they are taken
};

void PrintTo(const Bodies& bodies, std::ostream* out) {
  *out << bodies.name;
}

constexpr const char* kFaces = R"(,"faces":[[0,1,2]])";
constexpr const char* kTurn = R"(,"turn":{"from":[1,0],"to":[1,1]})";

const std::vector<Bodies> kBodyTable = {
    {"Hulls", "", "", ""},
    {"NegativeRadius", R"(,"radius":-1)", "", "patches[0].radius: -1 is negative"},
    {"Turn", kTurn, "", ""},
    {"TurnThroughZero", R"(,"turn":{"from":[1,0],"to":[0,1]})", "",
     "patches[0].turn.to: from·to is not > 0"},
    {"TurnOfTheOtherQuaternion", R"(,"turn":{"from":[1,0,0,0],"to":[-1,0,0,1]})", "",
     "patches[0].turn.to: from·to is not > 0: give -to, the same rotation"},
    {"SpinTooFast", R"(,"spin":{"velocity":[8,0,1.5]})", "",
     "patches[0].spin.velocity: [8, 0, 1.5] is of more than 8 radians in [0, 1]"},
    {"SpinOfNothing", R"(,"spin":{"velocity":[]})", "",
     "patches[0].spin.velocity: has 0 numbers, and needs 3"},
    {"SpinBesideTurn", R"(,"turn":{"from":[1,0],"to":[1,1]},"spin":{"velocity":[0,0,1]})", "",
     "patches[0].spin: stands beside a turn; a body has one of them"},
    {"Mesh", kFaces, "", ""},
    {"NoFaces", R"(,"faces":[])", "",
     "patches[0].faces: has none; a mesh has 1..8, and a hull no such key"},
    {"NineFaces",
     R"(,"faces":[[0,1,2],[0,1,2],[0,1,2],[0,1,2],[0,1,2],[0,1,2],[0,1,2],[0,1,2],[0,1,2]])", "",
     "patches[0].faces: has 9 triangles; a mesh has 1..8"},
    {"FaceOfNoPoint", R"(,"faces":[[0,1,2],[0,1,4]])", "",
     "patches[0].faces[1][2]: 4 is outside 0..3"},
    {"FaceOfANegativePoint", R"(,"faces":[[0,-1,2]])", "",
     "patches[0].faces[0][1]: -1 is outside 0..3"},
    {"FaceOfAPointPastIntegers", R"(,"faces":[[4294967298,1,2]])", "",
     "patches[0].faces[0][0]: 4294967298 is outside 0..3"},
    {"FaceOfTwoPoints", R"(,"faces":[[0,1]])", "", "patches[0].faces[0]: needs 3 items, not 2"},
    {"FaceOfTheSamePoint", R"(,"faces":[[0,1,2],[0,1,1]])", "",
     "patches[0].faces[1][2]: 1 is in the face twice"},
    {"RadiusOfAMesh", R"(,"radius":0.5,"faces":[[0,1,2]])", "",
     "patches[0].radius: 0.5 is not 0, as a mesh needs"},
    {"OneSidedHull", R"(,"sides":1)", "",
     "patches[0].sides: 1 is of a mesh, and there are no faces"},
    {"TwoMeshes", kFaces, kFaces,
     "patches[1].faces: stand beside patches[0].faces; one body of two may have them"},
    {"MeshThatTurns", R"(,"turn":{"from":[1,0],"to":[1,1]},"faces":[[0,1,2]])", "",
     "patches[0].turn: stands beside patches[0].faces; neither a mesh nor the other body may have "
     "one"},
    {"TurnBesideAMesh", kFaces, kTurn,
     "patches[1].turn: stands beside patches[0].faces; neither a mesh nor the other body may have "
     "one"},
    {"SpinBesideAMesh", R"(,"spin":{"velocity":[0,0,1]})", kFaces,
     "patches[0].spin: stands beside patches[1].faces; neither a mesh nor the other body may have "
     "one"},
};

class MalformedBody : public testing::TestWithParam<Bodies> {};
INSTANTIATE_TEST_SUITE_P(Table, MalformedBody, testing::ValuesIn(kBodyTable),
                         [](const auto& row) { return std::string(row.param.name); });

std::string body_with(const char* fields) {
  return R"({"shape":"hull","positions":[[0,0,0],[1,0,0],[0,1,0],[1,1,0]],"velocities":[[0,0,1]])" +
         std::string(fields) + '}';
}

TEST_P(MalformedBody, IsRefusedByFilePathAndValue) {
  const Bodies& bodies = GetParam();
  const auto parsed =
      parse_case(R"({"format":"ccdfuzz-case","version":2,"patches":[)" + body_with(bodies.first) +
                     ',' + body_with(bodies.second) + R"(],"t_max":1})",
                 "c.json");
  const std::string told = parsed ? "" : parsed.error().message(), message = bodies.message;
  EXPECT_EQ(told, message.empty() ? "" : "c.json: " + message);
  // Cases are written as they are read: without faces there is no such key.
  if (!parsed) return;
  const std::string written = to_json(*parsed, JsonLayout::kOneLine);
  EXPECT_EQ(written.find("\"faces\":") != std::string::npos, bodies.first == kFaces);
}

}  // namespace
}  // namespace ccdfuzz
