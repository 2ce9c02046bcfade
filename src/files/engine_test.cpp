#include "files/engine_test.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <optional>
#include <vector>

#include "base/read_double.hpp"
#include "base/verify.hpp"
#include "numeric/exact_scalars.hpp"

namespace ccdfuzz {

namespace {

constexpr std::array kAxes = {0, 1, 2};
/// Names of templates of engines that are asked about features.
constexpr const char *kVertexFace = "vertex-face", *kEdgeEdge = "edge-edge";

/// A body as the adapters give it to engines (examples/engines/bodies.mjs): its points about a
/// centre. The centre is the middle of its box, or 0 where that or a difference is no float.
struct EngineBody {
  Points<double> points;
  Vec3<double> centre{0, 0, 0};
  double radius = 0;
  std::optional<Vec3<double>> half;  ///< half the extents, where it is a box along the axes, or a
                                     ///< rectangle in the plane z = 0
};

bool is_float(double x) {
  return static_cast<double>(static_cast<float>(x)) == x;
}

EngineBody engine_body(const MovingPatch<double>& patch) {
  EngineBody body{patch.positions, {0, 0, 0}, patch.radius, {}};
  Vec3<double> low = patch.positions[0], high = low;
  for (const Vec3<double>& p : patch.positions) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  const Vec3<double> middle = (low + high) / 2;
  Points<double> about;
  bool is_exact = true;
  for (const Vec3<double>& p : patch.positions) {
    about.push_back(p - middle);
    for (const int k : kAxes) {
      is_exact = is_exact && is_float(middle[k]) && is_float(about.back()[k]) &&
                 exact(about.back()[k]) + exact(middle[k]) == exact(p[k]);
    }
  }
  if (!is_exact) return body;
  body.centre = middle;
  body.points = about;
  const Vec3<double> half = high - middle;
  const auto is_corner = [&](const Vec3<double>& p) { return p.cwiseAbs() == half; };
  std::vector<std::array<double, 3>> corners;
  for (const Vec3<double>& p : about) corners.push_back({p[0], p[1], p[2]});
  std::ranges::sort(corners);
  const bool are_different = std::ranges::adjacent_find(corners) == corners.end();
  const size_t count = half[2] > 0 ? 8 : 4;
  if (about.size() == count && are_different && std::ranges::all_of(about, is_corner)) {
    body.half = half;
  }
  return body;
}

std::string list(const Vec3<double>& v) {
  return fmt::format("{}, {}, {}", v[0], v[1], v[2]);
}

/// A text with each of these words in place of its name.
std::string filled(std::string text, const std::map<std::string_view, std::string>& words) {
  for (const auto& [name, word] : words) {
    for (size_t at = text.find(name); at != text.npos; at = text.find(name, at + word.size())) {
      text.replace(at, name.size(), word);
    }
  }
  return text;
}

/// The test of an engine (EngineTemplate): what it calls things, and the text.
struct Template {
  std::string_view engine;
  std::map<std::string, std::string, std::less<>> names;
  std::string text;

  explicit Template(const EngineTemplate& of) : engine(of.engine) {
    std::string_view file = of.text;
    constexpr std::string_view kMark = "//= ";
    while (file.starts_with(kMark)) {
      const std::string_view line = file.substr(kMark.size(), file.find('\n') - kMark.size());
      const size_t colon = line.find(": ");
      names.emplace(line.substr(0, colon), line.substr(colon + 2));
      file.remove_prefix(kMark.size() + line.size() + 1);
    }
    text = file;
  }

  /// Points as the engine's words for one have them.
  std::string list(const Points<double>& points) const {
    std::vector<std::string> texts;
    for (const Vec3<double>& p : points) {
      texts.push_back(filled(names.at("point"), {{"*", ccdfuzz::list(p)}}));
    }
    return fmt::format("{}", fmt::join(texts, ", "));
  }

  /// The engine's words for a body of this kind; nothing where it has none.
  std::optional<std::string> shape(const std::string& kind, const EngineBody& body) const {
    const auto name = names.find(kind);
    if (name == names.end()) return std::nullopt;
    std::vector<std::string> numbers;
    for (const Vec3<double>& p : body.points) numbers.push_back(ccdfuzz::list(p));
    const Vec3<double> half = body.half.value_or(Vec3<double>(0, 0, 0));
    return filled(name->second, {{"__POINTS__", list(body.points)},
                                 {"__NUMBERS__", fmt::format("{}", fmt::join(numbers, ", "))},
                                 {"__RADIUS__", fmt::format("{}", body.radius)},
                                 {"__HALF__", ccdfuzz::list(half)},
                                 {"__SIZE__", ccdfuzz::list(Vec3<double>(2 * half))}});
  }
};

/// A box is a hull, too, for an engine that has no box.
std::optional<std::string> shape_text(const Template& engine, const EngineBody& body) {
  constexpr std::array kKinds = {"point", "segment", "triangle", "hull"};
  const std::string round = body.radius > 0 ? "round " : "";
  const std::string kind = kKinds[std::min(body.points.size(), kKinds.size()) - 1];
  // "point" alone is how a point of a body is written.
  if (round.empty() && body.points.size() == 1) return std::nullopt;
  std::optional<std::string> text;
  if (body.half) text = engine.shape(round + ((*body.half)[2] > 0 ? "box" : "flat box"), body);
  return text ? text : engine.shape(round + kind, body);
}

constexpr const char* kGoogleTest = "#include <gtest/gtest.h>\n\n";

/// What every test ends with; share is undefined, or below 0 in C++, where the engine sees nothing.
std::string node_checks(const std::optional<double>& latest) {
  const std::string begin = "import assert from 'node:assert';\n";
  if (!latest) return begin + "assert(share === undefined, `a contact at ${share} of the way`);\n";
  return begin + fmt::format(
                     "assert(share !== undefined, 'the contact is missed');\n"
                     "assert(share <= {0}, `${{share}} is after {0} of the way`);\n",
                     *latest);
}
std::string google_checks(const std::optional<double>& latest) {
  if (!latest) return "  EXPECT_FALSE(touches) << \"at \" << share << \" of the way\";\n}\n";
  return fmt::format("  ASSERT_TRUE(touches);\n  EXPECT_LE(share, {});\n}}\n", *latest);
}

/// How much later than the contact the engine may be, as a part of the way. That is its own
/// tolerance in time, or the time in which bodies come as deep as its tolerance in space allows.
/// The direction that keeps them apart until the contact tells how fast that is.
double allowed_delay(const Case& value, const Template& engine) {
  const auto number = [&](std::string_view name) {
    double x = 0;
    if (const auto found = engine.names.find(name); found != engine.names.end()) {
      read_double(found->second.data(), found->second.data() + found->second.size(), x);
    }
    return x;
  };
  const double depth = number("depth");
  if (!(depth > 0)) return number("late");
  const auto& patches = value.query.patches;
  const Vec3<double> way =
      (patches[0].velocities[0] - patches[1].velocities[0]) * value.query.t_max;
  double speed = way.norm();
  if (const auto& clear = value.truth.clearance) {
    if (const auto* apart = std::get_if<BodyClearance>(&*clear)) {
      const Vec3<double> normal(apart->normal[0].get_d(), apart->normal[1].get_d(),
                                apart->normal[2].get_d());
      speed = std::abs(normal.dot(way)) / normal.norm();
    }
  }
  return speed > depth ? depth / speed : 1;
}

/// What is proven, in a line that a person can check.
std::string proof_text(const Case& value) {
  const auto& witness = value.truth.witness;
  if (!witness) {
    const auto contact = value.truth.contact_by();
    return contact ? fmt::format("They touch by t = {:.17g} of t_max = {}.", contact->get_d(),
                                 value.query.t_max)
                   : fmt::format("Nothing touches in [0, {}].", value.query.t_max);
  }
  std::vector<std::string> points;
  for (const size_t side : {size_t{0}, size_t{1}}) {
    const MovingPatch<double>& patch = value.query.patches[side];
    if (patch.shape.kind != ShapeKind::kHull) continue;
    Vec3<Rational> sum{Rational(0), Rational(0), Rational(0)};
    for (size_t i = 0; i < patch.positions.size(); ++i) {
      for (const int k : kAxes) {
        sum[k] += witness->weights[side][i] *
                  (exact(patch.positions[i][k]) + witness->t * exact(patch.velocity(i)[k]));
      }
    }
    points.push_back(
        fmt::format("({}, {}, {})", to_text(sum[0]), to_text(sum[1]), to_text(sum[2])));
  }
  const std::string at =
      fmt::format("At t = {} of t_max = {}", to_text(witness->t), value.query.t_max);
  if (points.empty()) return at + " they have a point in common.";
  return fmt::format(
      "{} the cores have the points\n// {} and {},\n// no farther apart than the "
      "radii together.",
      at, points[0], points[1]);
}

Result<std::string> features_text(const NamedCase& named, const Template& engine) {
  const Query query = with_velocities(named.value.query).value_or(named.value.query);
  const auto& [first, second] = query.patches;
  const bool is_face =
      first.shape.kind == ShapeKind::kPoint || second.shape.kind == ShapeKind::kPoint;
  const size_t count = first.positions.size() + second.positions.size();
  const bool is_linear =
      is_face
          ? count == 4 && (first.shape == Shape::triangle(1) || second.shape == Shape::triangle(1))
          : first.shape == Shape::curve(1) && second.shape == Shape::curve(1);
  if (!is_linear || has_ends(query) || is_trimmed(query) || query.separation > 0) {
    return input_error(
        named.id,
        fmt::format("{} has tests of a vertex and a whole face, or of two edges, that touch",
                    engine.engine));
  }
  std::array<Points<double>, 2> points;  // at 0 and at t_max
  const auto add = [&](const MovingPatch<double>& patch) {
    for (size_t i = 0; i < patch.positions.size(); ++i) {
      points[0].push_back(patch.positions[i]);
      points[1].emplace_back(patch.positions[i] + query.t_max * patch.velocities[i]);
    }
  };
  // A vertex comes after the face.
  const bool is_swapped = is_face && first.shape.kind == ShapeKind::kPoint;
  add(is_swapped ? second : first);
  add(is_swapped ? first : second);
  return filled(engine.text, {{"__CALL__", engine.names.at(is_face ? kVertexFace : kEdgeEdge)},
                              {"__START__", engine.list(points[0])},
                              {"__END__", engine.list(points[1])}});
}

Result<std::string> bodies_text(const NamedCase& named, const Template& engine) {
  const Query& query = named.value.query;
  if (!is_of_bodies(query)) {
    return input_error(named.id, fmt::format("{} is asked about bodies", engine.engine));
  }
  std::array<EngineBody, 2> bodies = {engine_body(query.patches[0]), engine_body(query.patches[1])};
  std::array<std::string, 2> shapes;
  for (size_t side = 0; side < 2; ++side) {
    const MovingPatch<double>& patch = query.patches[side];
    std::optional<std::string> shape = shape_text(engine, bodies[side]);
    if (!shape) shape = engine.shape("any", {patch.positions, {0, 0, 0}, patch.radius, {}});
    if (!shape || query.separation > 0) {
      return input_error(fmt::format("{}: patches[{}]", named.id, side),
                         fmt::format("{} has no such shape", engine.engine));
    }
    shapes[side] = *shape;
  }
  const Vec3<double> way =
      (query.patches[0].velocities[0] - query.patches[1].velocities[0]) * query.t_max;
  return filled(engine.text, {{"__A__", shapes[0]},
                              {"__B__", shapes[1]},
                              {"__CENTRE_A__", list(bodies[0].centre)},
                              {"__CENTRE_B__", list(bodies[1].centre)},
                              {"__WAY__", list(way)}});
}

}  // namespace

Result<std::string> engine_test(const NamedCase& named, std::string_view name) {
  const auto of_engine =
      std::ranges::find(engine_templates(), name, [](const EngineTemplate& e) { return e.engine; });
  CCDFUZZ_VERIFY(of_engine != engine_templates().end());
  const Case& value = named.value;
  const auto contact = value.truth.contact_by();
  const Rational t_max = exact(value.query.t_max);
  const bool touches = contact && *contact <= t_max && t_max > 0;
  const bool is_clear = value.truth.clearance && covers(*value.truth.clearance, t_max);
  if (!touches && !is_clear) {
    return input_error(named.id, "neither a contact within t_max nor its absence is proven");
  }
  const Template engine(*of_engine);
  std::optional<double> latest;
  if (touches) latest = round_up(Rational(*contact / t_max)) + allowed_delay(value, engine);
  const Result<std::string> asked = engine.names.contains(kVertexFace)
                                        ? features_text(named, engine)
                                        : bodies_text(named, engine);
  return asked.map([&](const std::string& text) {
    const std::string head = fmt::format("// {}\n", proof_text(value));
    return of_engine->is_cpp ? head + kGoogleTest + text + google_checks(latest)
                             : head + text + node_checks(latest);
  });
}

}  // namespace ccdfuzz
