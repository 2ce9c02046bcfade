#pragma once

#include <span>
#include <string>
#include <string_view>

#include "files/case_files.hpp"

namespace ccdfuzz {

/// The file find.mjs.in or find.cpp.in of an engine's folder in examples/engines: a test of the
/// engine alone, with words that stand for the numbers of a case. Its first lines, "//= NAME:
/// TEXT", say how the engine writes things. "point" is a point, whose coordinates stand for *.
/// "box", "flat box", "segment", "triangle" and "hull" are bodies, and "round point", "round box"
/// and so on those with a radius. Others are "any" where it takes them. It is asked of features by
/// "vertex-face" and "edge-edge". The test allows its own tolerance: "depth", or "late" as a part
/// of the way.
struct EngineTemplate {
  std::string_view engine;
  bool is_cpp;
  std::string_view text;
};
/// As they were when this program was built.
std::span<const EngineTemplate> engine_templates();

/// A complete test file that asks the engine itself the query of a case, as its adapter does. It
/// fails where the engine misses the proven contact, is late for it, or reports one where none is
/// proven. It needs nothing of ccdfuzz. For engines of npm it is a module for Node, for others a
/// GoogleTest. Requires a checked case, and an engine of engine_templates(). Errors, naming the
/// case: it is of other shapes than the engine has; neither a contact within t_max nor its absence
/// is proven.
Result<std::string> engine_test(const NamedCase& named, std::string_view engine);

}  // namespace ccdfuzz
