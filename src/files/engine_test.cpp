#include "files/engine_test.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <optional>
#include <vector>

#include "base/nearest_float.hpp"
#include "base/read_double.hpp"
#include "base/verify.hpp"
#include "case/mesh.hpp"
#include "case/scale.hpp"
#include "certify/checker/check_turning.hpp"
#include "numeric/exact_scalars.hpp"

namespace ccdfuzz {

namespace {

constexpr std::array kAxes = {0, 1, 2};
/// The name that every template of an engine that is asked about features has.
constexpr const char* kVertexFace = "vertex-face";

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
  return nearest_float(x) == x;
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

constexpr const char *kUntil = "__UNTIL__", *kApart = "__APART__", *kChecks = "__CHECKS__";

/// The test of an engine (EngineTemplate): what it calls things, and the text.
struct Template {
  std::string_view engine, ending;
  std::map<std::string, std::string, std::less<>> names;
  std::string text;

  explicit Template(const EngineTemplate& of) : engine(of.engine), ending(of.ending) {
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
      texts.push_back(filled(names.at("point"), {{"*", ccdfuzz::list(p)},
                                                 {"__X__", fmt::format("{}", p[0])},
                                                 {"__Y__", fmt::format("{}", p[1])}}));
    }
    return fmt::format("{}", fmt::join(texts, ", "));
  }

  bool has(std::string_view name) const { return names.find(name) != names.end(); }
  /// Whether it is given ends after a step that is a power of two, and exactly.
  bool is_exact() const { return text.find(kUntil) != text.npos; }
  bool takes_separation() const { return text.find(kApart) != text.npos; }

  /// The engine's words for a body of this kind; nothing where it has none.
  std::optional<std::string> shape(const std::string& kind, const EngineBody& body) const {
    const auto name = names.find(kind);
    if (name == names.end()) return std::nullopt;
    std::vector<std::string> numbers;
    for (const Vec3<double>& p : body.points) numbers.push_back(ccdfuzz::list(p));
    const Vec3<double> half = body.half.value_or(Vec3<double>(0, 0, 0));
    return filled(name->second, {{"__POINTS__", list(body.points)},
                                 {"__NUMBERS__", fmt::format("{}", fmt::join(numbers, ", "))},
                                 {"__COUNT__", fmt::format("{}", body.points.size())},
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

/// The whole test: with what the template says of a contact until `latest`, or of none. Else it
/// ends with what all of Node or of GoogleTest say; share is undefined, or below 0 in C++, where
/// the engine sees nothing.
std::string with_checks(const Template& engine, const std::string& text,
                        const std::optional<double>& latest) {
  const std::string by = latest ? fmt::format("{}", *latest) : "";
  if (engine.has("touches")) {
    const std::string& own = engine.names.find(latest ? "touches" : "clear")->second;
    return filled(text, {{kChecks, filled(own, {{"__LATEST__", by}, {"\\n", "\n"}})}});
  }
  if (engine.ending == ".mjs") {
    return text + "import assert from 'node:assert';\n" +
           (latest ? fmt::format("assert(share !== undefined, 'the contact is missed');\n"
                                 "assert(share <= {0}, `${{share}} is after {0} of the way`);\n",
                                 by)
                   : "assert(share === undefined, `a contact at ${share} of the way`);\n");
  }
  return "#include <gtest/gtest.h>\n\n" + text +
         (latest ? fmt::format("  ASSERT_TRUE(touches);\n  EXPECT_LE(share, {});\n}}\n", by)
                 : "  EXPECT_FALSE(touches) << \"at \" << share << \" of the way\";\n}\n");
}

/// The point of a body that a witness has, at time t. Requires a witness of bodies.
Vec3<Rational> point_of(const Case& value, size_t side, const Rational& t) {
  const MovingPatch<double>& body = value.query.patches[side];
  Vec3<Rational> sum{Rational(0), Rational(0), Rational(0)};
  for (size_t i = 0; i < body.positions.size(); ++i) {
    sum += value.truth.witness->weights[side][i] * exact(body.positions[i]);
  }
  Work work(kMostWork);
  const auto moved = moved_point(body, sum, t, work);
  return moved ? moved->point : sum;
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
    const auto* planes = std::get_if<BodyPlanes>(&*clear);
    if (planes != nullptr && value.truth.witness) {
      const Rational& t = value.truth.witness->t;
      const Rational shortly = t * power_of_two(-20);
      Rational towards = 0, square = 0;
      for (const int k : kAxes) {
        const Rational& n = planes->planes.back().normals[1][static_cast<size_t>(k)];
        towards += n * (point_of(value, 0, t)[k] - point_of(value, 0, t - shortly)[k]);
        towards -= n * (point_of(value, 1, t)[k] - point_of(value, 1, t - shortly)[k]);
        square += n * n;
      }
      speed = Rational(abs(towards) / shortly).get_d() / std::sqrt(square.get_d());
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
    if (!is_of_bodies(value.query)) continue;
    const Vec3<Rational> sum = point_of(value, side, witness->t);
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

/// The name in a template of a pair of linear shapes, the smaller first; "" if there is none.
std::string kind_of(const Query& query) {
  constexpr std::array kShapes = {Shape::point(), Shape::curve(1), Shape::triangle(1)};
  constexpr std::array kNames = {"vertex", "edge", "face"};
  std::array<long, 2> places;
  for (size_t side = 0; side < 2; ++side) {
    places[side] = std::ranges::find(kShapes, query.patches[side].shape) - kShapes.begin();
    if (places[side] == std::ssize(kShapes)) return "";
  }
  const auto [least, most] = std::ranges::minmax(places);
  return fmt::format("{}-{}", kNames.at(static_cast<size_t>(least)),
                     kNames.at(static_cast<size_t>(most)));
}

/// How long the step is, as the adapter makes it.
double step_of(const Query& query, const Template& engine) {
  if (has_ends(query)) return 1;
  return engine.is_exact() ? std::exp2(std::ceil(std::log2(query.t_max))) : query.t_max;
}

Result<std::string> features_text(const NamedCase& named, const Template& engine) {
  const Query query = with_velocities(named.value.query).value_or(named.value.query);
  const std::string kind = kind_of(query);
  if (!engine.has(kind) || is_trimmed(query) || (has_ends(query) && !engine.is_exact()) ||
      (query.separation > 0 && !engine.takes_separation())) {
    const char* why = is_of_bodies(query) ? "has no tests of bodies"
                                          : "has no tests of such shapes, motions or separations";
    return input_error(named.id, fmt::format("{} {}", engine.engine, why));
  }
  const double step = step_of(query, engine);
  std::array<Points<double>, 2> points;  // at 0 and after the step
  bool is_exact = true;
  const auto add = [&](const MovingPatch<double>& patch) {
    for (size_t i = 0; i < patch.positions.size(); ++i) {
      const Vec3<double>& start = points[0].emplace_back(patch.positions[i]);
      if (has_ends(query)) {
        points[1].push_back(patch.ends[i]);
        continue;
      }
      const Vec3<double>& velocity = patch.velocities[i];
      const Vec3<double>& end = points[1].emplace_back(start + step * velocity);
      for (const int k : kAxes) {
        is_exact = is_exact && exact(start[k]) + exact(step) * exact(velocity[k]) == exact(end[k]);
      }
    }
  };
  // A vertex comes after the face, unless the engine has it first.
  const bool is_vertex_first =
      query.patches[0].positions.size() < query.patches[1].positions.size();
  const size_t first = is_vertex_first == engine.has("vertex-first") ? 0 : 1;
  add(query.patches[first]);
  add(query.patches[1 - first]);
  if (engine.is_exact() && !is_exact) {
    return input_error(named.id, "an end of the motion is no double");
  }
  return filled(engine.text, {{"__CALL__", engine.names.find(kind)->second},
                              {"__START__", engine.list(points[0])},
                              {"__END__", engine.list(points[1])},
                              {kApart, fmt::format("{}", query.separation)},
                              {kUntil, fmt::format("{}", query.t_max / step)}});
}

/// The engine's words for how a body moves in a step of this length.
std::string sweep_text(const Template& engine, const MovingPatch<double>& body, double step) {
  if (!engine.has("still")) return "";
  const Vec3<double> way = step * body.velocities[0];
  if (!body.turn) return filled(engine.names.at("still"), {{"__END__", engine.list({way})}});
  const auto rotation = [&](const std::vector<double>& q) {
    std::string text = engine.names.at("rotation");
    for (size_t i = 0; i < q.size(); ++i) {
      text = filled(text, {{fmt::format("__{}__", i), fmt::format("{}", q[i])}});
    }
    return text;
  };
  return filled(engine.names.at("turn"), {{"__CENTRE__", engine.list({body.turn->centre})},
                                          {"__END__", engine.list({body.turn->centre + way})},
                                          {"__FROM__", rotation(body.turn->from)},
                                          {"__TO__", rotation(body.turn->to)}});
}

Result<std::string> bodies_text(const NamedCase& named, const Template& engine) {
  const Query& query = named.value.query;
  if (!is_of_bodies(query) || has_mesh(query)) {
    const char* why = has_mesh(query) ? "has no tests of meshes" : "is asked about convex bodies";
    return input_error(named.id, fmt::format("{} {}", engine.engine, why));
  }
  if (engine.has("plane") && !is_in_plane(query))
    return input_error(named.id, "is not in the plane z = 0");
  if (has_spins(query) || (has_turns(query) && !engine.has("turn")))
    return input_error(named.id, fmt::format("{} has no tests of such turns", engine.engine));
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
  const double fraction = has_turns(query) ? query.t_max : 1;  // turns are of a step of 1
  return filled(engine.text,
                {{"__A__", shapes[0]},
                 {"__B__", shapes[1]},
                 {"__CENTRE_A__", list(bodies[0].centre)},
                 {"__CENTRE_B__", list(bodies[1].centre)},
                 {"__WAY__", list(way)},
                 {"__SWEEP_A__", sweep_text(engine, query.patches[0], query.t_max / fraction)},
                 {"__SWEEP_B__", sweep_text(engine, query.patches[1], query.t_max / fraction)},
                 {"__FRACTION__", fmt::format("{}", fraction)}});
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
  const bool is_of_features = engine.has(kVertexFace);
  const double step = is_of_features           ? step_of(value.query, engine)
                      : has_turns(value.query) ? 1
                                               : value.query.t_max;
  std::optional<double> latest;
  if (touches) latest = round_up(Rational(*contact / exact(step))) + allowed_delay(value, engine);
  if (!latest && engine.has("touches") && !engine.has("clear")) {
    return input_error(
        named.id, fmt::format("{} may be early, so a test of it needs a contact", engine.engine));
  }
  const Result<std::string> asked =
      is_of_features ? features_text(named, engine) : bodies_text(named, engine);
  return asked.map([&](const std::string& text) {
    return fmt::format("// {}\n{}", proof_text(value), with_checks(engine, text, latest));
  });
}

}  // namespace ccdfuzz
