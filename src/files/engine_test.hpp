#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "files/case_files.hpp"

namespace ccdfuzz {

/// The file find.mjs.in, find.cpp.in or find.c.in of an engine's folder in examples/engines. It is
/// a test of the engine alone, with words that stand for the numbers of a case. Its first lines,
/// "//= NAME: TEXT", say how the engine writes things, where \n stands for the end of a line:
/// - "point" is a point, whose coordinates stand for *, or the first two for __X__ and __Y__.
/// - "box", "flat box", "segment", "triangle" and "hull" are bodies, and "round point", "round box"
///   and so on those with a radius, about their middle. "mesh" is a mesh of two sides, or of one if
///   there is "one-sided mesh"; "both sides" is what __SIDES__ stands for where it has two.
///   Others are "any" or "4 points" (of that many) as they are, and "turned any" where they turn.
///   __NAME__ in them is a or b. A "capsule axis" is where capsules lie before __TURN_A__ or
///   __TURN_B__.
/// - "still", "turn" and "spin" are how bodies move; a "rotation" is of cosine and sine, or of four
///   numbers, __0__ to __3__.
/// - "vertex-face", "edge-edge", "vertex-edge" and "vertex-vertex" are calls about features;
///   "vertex-first" says that a vertex comes before the face.
/// - "still promise" says that what is promised is of bodies that do not turn alone.
/// - "plane" says that bodies are those of the plane z = 0.
/// - "float end" says that the first body is given its end, a float: other ends are refused.
/// - "call" begins the call that asks the engine. What is before it sets up the query.
/// - "depth" is the tolerance, or "late" as a part of the way. "mesh depth" and "spin depth" are
///   those of meshes and of bodies that spin, where they differ.
/// - What __CHECKS__ stands for is "touches" where there is a contact and "clear" where there is
///   none, in a framework of the engine's own. Without "clear" it may be early.
/// A helper between the lines "//: NAME" and "//:" is left out where nothing calls it.
struct EngineTemplate {
  std::string_view engine;
  std::string_view ending;  ///< .mjs, .cpp or .c
  std::string_view text;
  std::string_view mesh_text;  ///< find-mesh.cpp.in, a test about meshes alone, or empty
  std::string_view promise;    ///< promise.json: what the engine says that it does, and where
  std::string_view overlap;    ///< overlap.json: what it says of bodies in contact at 0, or empty
};
/// As they were when this program was built.
std::span<const EngineTemplate> engine_templates();

/// How much of a test is made: all, or the query alone, which tells at once whether there is a
/// test. How late an answer may be takes up to 0.1 s to find.
enum class TestPart : std::uint8_t { kAll, kQuestion };

/// A complete test file that asks the engine itself the query of a case, as its adapter does. It
/// fails where the engine misses the proven contact, is late for it, or reports one where none is
/// proven. Late is what outcome_of takes for late, by the engine's own tolerance. It needs nothing
/// of ccdfuzz. For engines of npm it is a module for Node, for others a GoogleTest or what the
/// template says. Requires a checked case, and an engine of engine_templates(). Errors, naming the
/// case: it is of other shapes than the engine has; neither a contact within t_max nor its absence
/// is proven. Or nothing touches, and the engine may be early.
Result<std::string> engine_test(const NamedCase& named, std::string_view engine,
                                TestPart part = TestPart::kAll);

}  // namespace ccdfuzz
