#include "files/engine_test.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numeric>
#include <optional>
#include <vector>

#include "base/nearest_float.hpp"
#include "base/read_double.hpp"
#include "base/text.hpp"
#include "base/verify.hpp"
#include "case/mesh.hpp"
#include "case/scale.hpp"
#include "certify/checker/check_case.hpp"
#include "certify/checker/check_turning.hpp"
#include "certify/oracle/body_depth.hpp"
#include "certify/oracle/outcome_of.hpp"
#include "files/engine_words.hpp"
#include "numeric/exact_scalars.hpp"

namespace ccdfuzz {

namespace {

constexpr std::array kAxes = {0, 1, 2};
/// The name that every template of an engine that is asked about features has.
constexpr const char* kVertexFace = "vertex-face";

/// The whole test: with what the template says of a contact until `latest`, or of none. Else it
/// ends with what all of Node or of GoogleTest say; share is undefined, or below 0 in C++, where
/// the engine sees nothing.
std::string with_checks(const EngineWords& engine, const std::string& text,
                        const std::optional<double>& latest) {
  const std::string by = latest ? fmt::format("{}", *latest) : "";
  if (engine.has("touches")) {
    const std::string& own = engine.names.at(latest ? "touches" : "clear");
    return filled(text, {{kChecks, filled(own, {{"__LATEST__", by}})}});
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

/// Exactly, or rounded where a number is long: a point of a body that spins has many digits.
std::string readable(const std::vector<Rational>& numbers) {
  constexpr size_t kReadable = 12;
  std::vector<std::string> exactly, nearly;
  for (const Rational& x : numbers) {
    exactly.push_back(to_text(x));
    nearly.push_back(fmt::format("{:.9g}", x.get_d()));
  }
  const bool is_long =
      std::ranges::any_of(exactly, [](const std::string& text) { return text.size() > kReadable; });
  const std::string joined = fmt::format("{}", fmt::join(is_long ? nearly : exactly, ", "));
  const std::string text = numbers.size() > 1 ? fmt::format("({})", joined) : joined;
  return is_long ? "about " + text : text;
}

/// The point of a body that a witness has, at its time. Requires a witness of bodies.
Vec3<Rational> touched_point(const Case& value, size_t side) {
  const MovingPatch<double>& body = value.query.patches[side];
  const Witness& witness = *value.truth.witness;
  Vec3<Rational> sum{Rational(0), Rational(0), Rational(0)};
  for (size_t i = 0; i < body.positions.size(); ++i) {
    sum += witness.weights[side][i] * exact(body.positions[i]);
  }
  Work work(kMostWork);
  return moved_point(body, sum, witness.t, work).point;
}

/// The place of the body that the test has first: a mesh is the second.
size_t first_body(const Query& query) {
  return has_mesh(query) ? 1 - mesh_side(query) : 0;
}

/// What is proven, in a line that a person can check. Times are parts of the step. Points are where
/// the test has them: it may move the first body alone, as the second sees it.
/// touches: by t_max.
std::string proof_text(const Case& value, const EngineWords& engine, double step, bool touches) {
  const Query& query = value.query;
  const auto& witness = value.truth.witness;
  const bool is_apart = query.separation > 0;
  if (!touches) {
    const std::string nothing =
        is_apart ? fmt::format("Nothing comes as near as {}", query.separation) : "Nothing touches";
    if (query.t_max >= step) return nothing + " on the way.";
    const Rational part = exact(query.t_max) / exact(step);
    return fmt::format("{} in the first {} of the way.", nothing, readable({part}));
  }
  const std::string apart = fmt::format("{} apart or less", query.separation);
  if (!witness) {
    const Rational part = *value.truth.contact_by() / exact(step);
    return fmt::format("They {} by {:.17g} of the way.", is_apart ? "are " + apart : "touch",
                       part.get_d());
  }
  const std::string at = fmt::format("At {} of the way", readable({witness->t / exact(step)}));
  if (!is_of_bodies(query)) {
    return fmt::format("{} they {}.", at, is_apart ? "are " + apart : "have a point in common");
  }
  const size_t first = first_body(query), second = 1 - first;
  std::array<std::string, 2> points;
  for (const size_t side : {first, second}) {
    Vec3<Rational> p = touched_point(value, side);
    if (engine.moves_one()) p -= witness->t * exact(query.patches[second].velocities[0]);
    points[side] = readable({p[0], p[1], p[2]});
  }
  const double radii = query.patches[0].radius + query.patches[1].radius;
  if (radii == 0) return fmt::format("{} both have the point {}.", at, points[first]);
  return fmt::format(
      "{} the bodies without their radii have the points\n"
      "// {} and {}, no farther apart than the radii together: {}.",
      at, points[first], points[second], radii);
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

/// How long the step is in which a share of 1 ends, as the adapter makes it.
double step_of(const Query& query, const EngineWords& engine) {
  if (has_ends(query) || (has_turns(query) && engine.has("turn"))) return 1;
  return engine.is_exact() ? std::exp2(std::ceil(std::log2(query.t_max))) : query.t_max;
}

/// A number that `origin` of a find says; 0 where it says none.
double said_of(const Origin& origin, const char* name) {
  const auto said = origin.more.find(name);
  double x = 0;
  if (said != origin.more.end()) {
    read_double(said->second.data(), said->second.data() + said->second.size(), x);
  }
  return x;
}

/// Whether the plug-in of the engine's name was asked about the case.
bool is_find_of(const Case& value, std::string_view engine) {
  return value.expect.contains(fmt::format("plugin:{}", engine));
}

/// By what an answer of the engine is judged: its own tolerances, or what its judge allowed, if the
/// case is a find of it. Far from the origin that is more.
AnswerTerms terms_of(const Case& value, const EngineWords& engine, double step) {
  const bool is_of_engine = is_find_of(value, engine.engine);
  const auto allowed = [&](double own, const char* name) {
    return is_of_engine ? std::max(own, said_of(value.origin, name)) : own;
  };
  const char* depth = has_mesh(value.query)    ? "mesh depth"
                      : has_spins(value.query) ? "spin depth"
                                               : "depth";
  AnswerTerms terms;
  terms.time_tolerance = allowed(engine.number("late") * step, kTimeAllowed);
  terms.depth_tolerance =
      allowed(engine.number(engine.has(depth) ? depth : "depth"), kDepthAllowed);
  terms.in_plane = engine.has("plane");
  return terms;
}

/// How much later than the contact hits are judged right, as a part of a step, rounded up to six
/// digits. What turns may be judged right again after it has passed through. Nothing is allowed
/// from where on nothing is known of a hit.
double allowed_delay(const Case& value, const AnswerTerms& terms, double step) {
  const CheckedCase known = checked_or_unknown(value);
  const Rational contact = *value.truth.contact_by();
  const auto& [a, b] = value.query.patches;
  const bool is_open =
      has_turns(value.query) && is_measured(a.positions.size(), b.positions.size());
  const auto is_late = [&](double t) {
    const Outcome outcome = outcome_of(known, Answer::hit(t), terms, true);
    // What turns is not proven to be right, but it is wrong from where on it is deeper.
    return is_open ? is_false_negative(outcome) : outcome != Outcome::kCorrect;
  };
  constexpr int kDoublings = 20;
  const double begin = round_down(contact), way = value.query.t_max - begin;
  double right = begin, late = begin;
  for (int left = kDoublings; left >= 0 && !is_late(late); --left) {
    right = late;
    late = left == 0 ? value.query.t_max : begin + std::ldexp(way, -left);
  }
  if (!is_late(late)) right = late;
  for (double t; t = std::midpoint(right, late), right < t && t < late;) {
    (is_late(t) ? late : right) = t;
  }
  const double delay = Rational((exact(right) - contact) / exact(step)).get_d();
  if (!(delay > 0)) return 0;
  const auto rounded = [](double x) {
    return std::strtod(fmt::format("{:.6g}", x).c_str(), nullptr);
  };
  const double unit = std::pow(10, std::floor(std::log10(delay)) - 5), nearest = rounded(delay);
  // More than depths are off by, which are right to a few ulps; less than any digit here.
  constexpr double kOff = 0x1p-40;
  return nearest < delay * (1 - kOff) ? rounded(nearest + unit) : nearest;
}

Result<std::string> features_text(const NamedCase& named, const EngineWords& engine) {
  const Query query = with_velocities(named.value.query).value_or(named.value.query);
  const std::string kind = kind_of(query);
  if (!engine.has(kind) || is_trimmed(query) || (has_ends(query) && !engine.is_exact()) ||
      (query.separation > 0 && !engine.takes_separation())) {
    const char* why = is_of_bodies(query) ? "has no tests of bodies"
                                          : "has no tests of such shapes, motions or separations";
    return input_error(named.id, "{} {}", engine.engine, why);
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
  return filled(engine.text, {{"__CALL__", engine.names.at(kind)},
                              {"__START__", engine.list(points[0])},
                              {"__END__", engine.list(points[1])},
                              {kApart, fmt::format("{}", query.separation)},
                              {kUntil, fmt::format("{}", query.t_max / step)}});
}

Result<std::string> bodies_text(const NamedCase& named, const EngineWords& engine) {
  const Query& query = named.value.query;
  const auto refused = [&](std::string_view why) {
    return input_error(named.id, "{} {}", engine.engine, why);
  };
  if (engine.has("plane") && !is_in_plane(query))
    return input_error(named.id, "is not in the plane z = 0");
  const bool has_one = has_mesh(query);
  const size_t first = first_body(query);
  const std::array bodies = {&query.patches[first], &query.patches[1 - first]};
  if (has_one && !engine.has(bodies[1]->one_sided ? "one-sided mesh" : "mesh"))
    return refused(bodies[1]->one_sided ? "has no tests of one-sided meshes"
                                        : "has no tests of meshes");
  const bool has_two_sides = has_one && !bodies[1]->one_sided;
  const std::string sides = has_two_sides ? engine.word("both sides").value_or("") : "";
  const double step = step_of(query, engine);
  std::array<EngineWords::Shaped, 2> shapes;
  std::array<std::string, 2> sweeps;
  for (size_t side = 0; side < 2; ++side) {
    const auto shape = engine.shape(*bodies[side]);
    if (!shape || query.separation > 0) {
      const size_t place = side == 0 ? first : 1 - first;
      return input_error(fmt::format("{}: patches[{}]", named.id, place), "{} has no such shape",
                         engine.engine);
    }
    shapes[side] = *shape;
    const std::map<std::string_view, std::string> names = {{"__NAME__", side == 0 ? "a" : "b"}};
    shapes[side].text = filled(shape->text, names);
    const auto sweep = engine.sweep(*bodies[side], shape->body, step);
    if (!sweep) return refused("has no tests of such turns");
    sweeps[side] = filled(*sweep, names);
  }
  const Vec3<double> way = (bodies[0]->velocities[0] - bodies[1]->velocities[0]) * query.t_max;
  const auto is_float_end = [&](int k) {
    const double start = shapes[0].body.centre[k], end = start + way[k];
    return nearest_float(end) == end && end - way[k] == start;
  };
  if (engine.has("float end") && !std::ranges::all_of(kAxes, is_float_end))
    return refused("is given an end, and here it is no float");
  return without_idle_helpers(
      filled(engine.text, {{"__A__", shapes[0].text},
                           {"__B__", shapes[1].text},
                           {"__CENTRE_A__", list(shapes[0].body.centre)},
                           {"__CENTRE_B__", list(shapes[1].body.centre)},
                           {"__TURN_A__", engine.rotation(shapes[0].body.turn)},
                           {"__TURN_B__", engine.rotation(shapes[1].body.turn)},
                           {kWay, list(way)},
                           {"__SIDES__", sides},
                           {"__SWEEP_A__", sweeps[0]},
                           {"__SWEEP_B__", sweeps[1]},
                           {"__FRACTION__", fmt::format("{}", query.t_max / step)}}));
}

/// A comment that says with which version of the engine the case was found, and how deep. Nothing
/// where the file does not say it of the plug-in of the engine's name. Only in ASCII: in JavaScript
/// a comment ends at some other characters, too.
std::string origin_text(const Case& value, std::string_view engine, double tolerance) {
  const Origin& origin = value.origin;
  const auto version = origin.more.find("version");
  if (version == origin.more.end() || !is_find_of(value, engine)) return "";
  const bool is_plain =
      std::ranges::all_of(version->second, [](char c) { return ' ' <= c && c <= '~'; });
  if (!is_plain) return "";
  return fmt::format("// Found with version {}{}.\n", version->second,
                     beside_tolerance(said_of(origin, "depth"), "deep", tolerance));
}

}  // namespace

Result<std::string> engine_test(const NamedCase& named, std::string_view name, TestPart part) {
  const auto of_engine =
      std::ranges::find(engine_templates(), name, [](const EngineTemplate& e) { return e.engine; });
  CCDFUZZ_VERIFY(of_engine != engine_templates().end());
  const Case& value = named.value;
  const auto contact = value.truth.contact_by();
  const Rational t_max = exact(value.query.t_max);
  const bool touches = contact && *contact <= t_max;
  if (touches && t_max == 0) {
    return input_error(named.id, "touches at a t_max of 0, and engines are asked to move bodies");
  }
  const bool is_clear = value.truth.clearance && covers(*value.truth.clearance, t_max);
  if (!touches && !is_clear) {
    return input_error(named.id, "neither a contact within t_max nor its absence is proven");
  }
  const EngineWords engine(*of_engine, has_mesh(value.query));
  const bool is_of_features = engine.has(kVertexFace);
  if (!is_of_features && !is_of_bodies(value.query)) {
    return input_error(named.id, "{} is asked about bodies", engine.engine);
  }
  if (!touches && engine.has("touches") && !engine.has("clear")) {
    return input_error(named.id, "{} may be early, so a test of it needs a contact", engine.engine);
  }
  const Result<std::string> question =
      is_of_features ? features_text(named, engine) : bodies_text(named, engine);
  if (!question || part == TestPart::kQuestion) return question;
  const Query moved = with_velocities(value.query).value_or(value.query);
  const double step = step_of(moved, engine);
  const AnswerTerms terms = terms_of(value, engine, step);
  std::optional<double> latest;
  const double delay = touches ? allowed_delay(value, terms, step) : 0;
  if (touches) latest = round_up(Rational(*contact / exact(step))) + delay;
  std::string proof = origin_text(value, name, terms.depth_tolerance);
  const bool starts_in_contact = touches && *contact == 0 && is_of_bodies(value.query);
  const std::string_view promise = starts_in_contact ? of_engine->overlap : of_engine->promise;
  if (!promise.empty() && (!engine.has("still promise") || !has_turns(value.query))) {
    proof = fmt::format("// Promised: {}\n{}", promise, proof);
  }
  proof += fmt::format("// {}\n", proof_text(value, engine, step, touches));
  if (delay > 0)
    proof += fmt::format("// The engine's tolerance is allowed: {:.2g} of the way.\n", delay);
  return proof + with_checks(engine, *question, latest);
}

}  // namespace ccdfuzz
