#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "case/query.hpp"
#include "files/engine_test.hpp"

// What the test of an engine calls bodies and their motions.

namespace ccdfuzz {

/// How a file of tests of a plug-in begins (test_preamble), as it was when this program was built.
/// __FRAMEWORK__ stands for the headers of the test framework.
std::string_view plugin_test_template();

/// A body as the adapters give it to engines (examples/engines/bodies.mjs): its points about a
/// centre. The centre is the middle of its box, or 0 where that or a difference is no float.
struct EngineBody {
  Points<double> points;
  Vec3<double> centre{0, 0, 0};
  double radius = 0;
  std::optional<Vec3<double>> half = {};  ///< half the extents, where it is a box along the axes,
                                          ///< or a rectangle in the plane z = 0
  std::vector<Face> faces = {};
  std::vector<double> turn = {1, 0, 0, 0};  ///< w, x, y, z from the axis of a capsule, in floats
};

/// "1, 2, 3"
std::string list(const Vec3<double>& v);
/// A text with each of these words in place of its name.
std::string filled(std::string text, const std::map<std::string_view, std::string>& words);
/// A text without the helpers that nothing after them calls. A helper is between the lines "//:
/// NAME" and "//:".
std::string without_idle_helpers(std::string text);

constexpr const char *kUntil = "__UNTIL__", *kApart = "__APART__", *kChecks = "__CHECKS__",
                     *kWay = "__WAY__";

/// The test of an engine (EngineTemplate): what it calls things, and the text.
struct EngineWords {
  std::string_view engine, ending;
  std::map<std::string, std::string, std::less<>> names;
  std::string text;

  /// Takes the test that the engine has for meshes alone if `of_meshes`, and it has one.
  EngineWords(const EngineTemplate& of, bool of_meshes);

  bool has(std::string_view name) const { return names.find(name) != names.end(); }
  /// What a name says; nothing where it is not there.
  std::optional<std::string> word(std::string_view name) const;
  /// 0 where the name is not there.
  double number(std::string_view name) const;
  /// Whether it is given ends after a step that is a power of two, and exactly.
  bool is_exact() const { return text.find(kUntil) != text.npos; }
  /// Whether it moves the first body alone, by the way of both.
  bool moves_one() const { return text.find(kWay) != text.npos; }
  bool takes_separation() const { return text.find(kApart) != text.npos; }

  /// Points as the engine's words for one have them.
  std::string list(const Points<double>& points) const;

  /// The words for a rotation of two or of four numbers.
  std::string rotation(const std::vector<double>& q) const;

  /// The words for a body, and the body as they have it. A box is a hull, too, for an engine that
  /// has no box. Nothing where the engine has no such shape.
  struct Shaped {
    EngineBody body;
    std::string text;
  };
  std::optional<Shaped> shape(const MovingPatch<double>& patch) const;

  /// The words for how a body moves in a step of this length. Nothing where it turns as the engine
  /// has no words for, or by numbers that are not of unit length. Empty where they move in the
  /// text.
  std::optional<std::string> sweep(const MovingPatch<double>& patch, const EngineBody& body,
                                   double step) const;

 private:
  std::optional<Shaped> shape(const std::string& name, const MovingPatch<double>& patch,
                              const EngineBody& body) const;
};

}  // namespace ccdfuzz
