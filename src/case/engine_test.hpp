#pragma once

#include <span>
#include <string>
#include <string_view>

#include "case/case_files.hpp"

namespace ccdfuzz {

/// The file find.mjs.in or find.cpp.in of an engine's folder in examples/engines: a test of the
/// engine alone, with words that stand for the numbers of a case. Its first lines, "//= NAME:
/// TEXT", say how the engine writes a point, whose coordinates stand for *, and each kind of body:
/// box, segment, triangle or hull, and with a radius round point, round segment and so on. Others
/// are "any" where it takes them; vertex-face and edge-edge are what it is asked of features by.
/// "depth", or "late" as a part of the way, is its own tolerance, which the test allows.
struct EngineTemplate {
  std::string_view engine;
  bool is_cpp;
  std::string_view text;
};
/// As they were when this program was built.
std::span<const EngineTemplate> engine_templates();

/// A complete test file that asks the engine itself the query of a case, as its adapter does, and
/// fails where the engine misses the proven contact, or is late for it, or reports one where none
/// is proven. It needs nothing of ccdfuzz: for engines of npm it is a module for Node, for others
/// a GoogleTest. Requires a checked case, and an engine of engine_templates(). Errors: the case is
/// of other shapes than the engine has, or neither a contact within t_max nor its absence is
/// proven; naming the case.
Result<std::string> engine_test(const NamedCase& named, std::string_view engine);

}  // namespace ccdfuzz
