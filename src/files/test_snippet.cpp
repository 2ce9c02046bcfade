#include "files/test_snippet.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "base/text.hpp"
#include "case/scale.hpp"
#include "numeric/products.hpp"

namespace ccdfuzz {

namespace {

constexpr const char* kPreamble = R"(#include <ccdfuzz_plugin.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>

{0}
namespace {{

ccdfuzz_patch make_patch(std::uint32_t shape, std::uint32_t degree_u, std::uint32_t degree_v,
                         std::uint64_t count, const double (*positions)[3],
                         const double (*velocities)[3], const double (*ends)[3] = nullptr,
                         const double* weights = nullptr, double radius = 0) {{
  return {{sizeof(ccdfuzz_patch), shape, degree_u, degree_v, count,
          positions, velocities, ends, weights, radius,
          0, nullptr, nullptr, 0, nullptr, nullptr, {{}}, 0, nullptr, 0}};
}}

/// The plug-in that this is linked with.
struct Plugin {{
  const ccdfuzz_plugin* const table = ccdfuzz_plugin_get();
  void* state = nullptr;
  ccdfuzz_description description{{}};

  Plugin() {{
    const char* const given = std::getenv("CCDFUZZ_PLUGIN_OPTIONS");
    const std::string options = given != nullptr ? given : "";
    if (table->create(options.c_str(), &state) != 0) {{
      throw std::runtime_error("the plug-in refuses CCDFUZZ_PLUGIN_OPTIONS=\"" + options + "\"");
    }}
    description.size = sizeof description;
    table->describe(state, &description);
  }}
  ~Plugin() {{ table->destroy(state); }}
}};

/// The patch as ccdfuzz asks about it. A plug-in gets one of ends and velocities. One that takes no
/// weights gets no equal ones.
ccdfuzz_patch as_taken(ccdfuzz_patch patch, std::uint32_t claims) {{
  if (patch.velocities != nullptr && patch.ends != nullptr) {{
    ((claims & CCDFUZZ_TAKES_ENDS) != 0 ? patch.velocities : patch.ends) = nullptr;
  }}
  const double* const weights = patch.weights;
  const bool are_equal = weights != nullptr && std::all_of(weights, weights + patch.count,
                                                           [=](double w) {{ return w == *weights; }});
  if (are_equal && (claims & CCDFUZZ_TAKES_WEIGHTS) == 0) patch.weights = nullptr;
  return patch;
}}

/// Asks it, with the patches in the order that it takes.
ccdfuzz_answer ask(ccdfuzz_patch a, ccdfuzz_patch b, double t_max, double separation = 0) {{
  const Plugin plugin;
  ccdfuzz_answer answer{{}};
  const ccdfuzz_description& description = plugin.description;
  const auto takes = [&](const ccdfuzz_patch& first, const ccdfuzz_patch& second) {{
    return std::any_of(description.pairs, description.pairs + description.pair_count,
                       [&](const ccdfuzz_pair& pair) {{
                         return pair.shapes[0] == first.shape && pair.shapes[1] == second.shape;
                       }});
  }};
  if (!takes(a, b) && takes(b, a)) std::swap(a, b);
  a = as_taken(a, description.claims);
  b = as_taken(b, description.claims);
  ccdfuzz_query query{{}};
  query.size = sizeof query;
  query.patches[0] = &a;
  query.patches[1] = &b;
  query.t_max = t_max;
  query.precision = 1e-4;
  query.max_iterations = 1000000;
  query.max_seconds = 60;
  query.separation = separation;
  answer.size = sizeof answer;
  answer.toi_lower = answer.toi_upper = answer.tolerance = std::nan("");
  for (auto& uv : answer.uv) uv[0] = uv[1] = std::nan("");
  if (plugin.table->answer(plugin.state, &query, &answer) != 0) answer.verdict = CCDFUZZ_ERROR;
  return answer;
}}

/// Whether the plug-in claims that, such as CCDFUZZ_CLOSED_T_MAX.
[[maybe_unused]] bool claims(std::uint32_t claim) {{
  return (Plugin().description.claims & claim) != 0;
}}

/// What the plug-in and its answer tolerate of a kind, which may be relative to a whole.
[[maybe_unused]] double tolerated(const ccdfuzz_answer& answer, std::uint32_t absolute,
                                  std::uint32_t relative, double whole) {{
  const ccdfuzz_description claimed = Plugin().description;
  const bool is_relative = claimed.tolerance_kind == relative;
  double most = is_relative || claimed.tolerance_kind == absolute ? claimed.tolerance : 0;
  if (claims(CCDFUZZ_CONSERVATIVE)) most = 0;
  if (answer.tolerance < most) most = answer.tolerance;
  return is_relative ? most * whole : most;
}}

/// Whether a hit is no later than the tolerance in time that the plug-in claims allows.
[[maybe_unused]] bool is_in_time(const ccdfuzz_answer& answer, double contact, double t_max) {{
  return answer.toi_lower - contact <=
         tolerated(answer, CCDFUZZ_TOLERANCE_TIME, CCDFUZZ_TOLERANCE_TIME_RELATIVE, t_max);
}}

/// Whether a miss or late hit of bodies overlooks no more than the plug-in tolerates in space. They
/// come nearer at this speed, along a direction that keeps them apart until `since`.
[[maybe_unused]] bool is_shallow(const ccdfuzz_answer& answer, double speed, double since,
                                 double t_max, double largest) {{
  const double depth =
      tolerated(answer, CCDFUZZ_TOLERANCE_SPACE, CCDFUZZ_TOLERANCE_SPACE_RELATIVE, largest);
  const double until = answer.verdict == CCDFUZZ_HIT ? answer.toi_lower : t_max;
  return !claims(CCDFUZZ_CONSERVATIVE) &&
         speed * (until - since) <= depth + Plugin().description.minimum_separation;
}}

/// Whether a hit without a contact may be near enough for what the plug-in claims: a separation, or
/// a tolerance in space. `ccdfuzz replay` measures distances, these tests do not.
[[maybe_unused]] bool may_be_near() {{
  const ccdfuzz_description claimed = Plugin().description;
  return claimed.minimum_separation > 0 || claimed.tolerance_kind == CCDFUZZ_TOLERANCE_SPACE ||
         claimed.tolerance_kind == CCDFUZZ_TOLERANCE_SPACE_RELATIVE;
}}

/// Whether it is an answer to a query about [0, t_max] at all.
bool is_answer(const ccdfuzz_answer& answer, double t_max) {{
  if (answer.verdict != CCDFUZZ_HIT) {{
    return answer.verdict == CCDFUZZ_MISS || answer.verdict == CCDFUZZ_INCONCLUSIVE ||
           answer.verdict == CCDFUZZ_REFUSED;
  }}
  return answer.toi_lower >= 0 && answer.toi_lower <= t_max;
}}

}}  // namespace
)";

constexpr const char* kGoogleTestHeader = "#include <gtest/gtest.h>\n";
constexpr const char* kCatch2Header = R"(#if __has_include(<catch2/catch_test_macros.hpp>)
#include <catch2/catch_test_macros.hpp>
#else
#include <catch2/catch.hpp>
#endif
)";

/// "CCDFUZZ_POINT".
std::string abi_name(ShapeKind kind) {
  std::string name = fmt::format("CCDFUZZ_{}", name_of(kind));
  std::ranges::transform(name, name.begin(), [](unsigned char c) { return std::toupper(c); });
  return name;
}

std::string points_text(const std::string& name, const Points<double>& points) {
  std::string out = fmt::format("  const double {}[][3] = {{", name);
  for (size_t i = 0; i < points.size(); ++i) {
    out += fmt::format("{}\n      {{{}, {}, {}}}", i == 0 ? "" : ",", to_hex(points[i][0]),
                       to_hex(points[i][1]), to_hex(points[i][2]));
  }
  return out + "};\n";
}

std::string weights_text(const std::string& name, const std::vector<double>& weights) {
  std::vector<std::string> numbers;
  for (const double w : weights) numbers.push_back(to_hex(w));
  return fmt::format("  const double {}[] = {{{}}};\n", name, fmt::join(numbers, ", "));
}

std::string check_text(TestFramework framework, const std::string& condition) {
  return fmt::format("  {}({});\n",
                     framework == TestFramework::kGoogleTest ? "EXPECT_TRUE" : "CHECK", condition);
}

/// Letters, digits and '_' of the file's name.
std::string test_name(const std::string& id, size_t number) {
  std::string name = id.substr(id.find_last_of('/') + 1);
  name = name.substr(0, name.find(".json"));
  for (char& c : name) {
    if (std::isalnum(static_cast<unsigned char>(c)) == 0) c = '_';
  }
  return fmt::format("Case{}_{}", number, name);
}

/// Requires that the certificate was checked. What a case says without one is not demanded of a
/// method.
bool is_proven_clear(const Case& value) {
  const auto& clearance = value.truth.clearance;
  return clearance && covers(*clearance, exact(value.query.t_max));
}

/// What is proven, for people.
std::string truth_text(const Case& value) {
  const Truth& truth = value.truth;
  if (truth.witness && truth.collides == true && !is_of_bodies(value.query)) {
    const auto& uv = truth.witness->uv;
    return fmt::format("they touch at t = {}, (u, v) = ({}, {}) and ({}, {}), exactly",
                       to_text(truth.witness->t), to_text(uv[0][0]), to_text(uv[0][1]),
                       to_text(uv[1][0]), to_text(uv[1][1]));
  }
  if (truth.collides == true) return "they touch by t = " + to_text(*truth.contact_by());
  if (is_proven_clear(value)) return "nothing touches in [0, t_max]";
  return "nothing is proven of contacts: an answer is all that is wanted";
}

/// What these tests have no place for; nothing if a query has none of it.
std::optional<std::string> without_place(const Query& query) {
  for (size_t side = 0; side < 2; ++side) {
    const MovingPatch<double>& patch = query.patches[side];
    const char* field = !patch.trim.empty()     ? "trim"
                        : !patch.faces.empty()  ? "faces"
                        : !patch.turn           ? nullptr
                        : patch.turn->is_spin() ? "spin"
                                                : "turn";
    if (field != nullptr) return fmt::format("patches[{}].{}", side, field);
  }
  return std::nullopt;
}

/// " || condition" where a plug-in may be in the right although it misses the contact or is late.
/// It does not claim to find it, or tolerates what it overlooks of bodies.
std::string excuse_text(const Case& value, const Rational& contact) {
  const Query& query = value.query;
  std::string out;
  if (contact == exact(query.t_max)) out += " || !claims(CCDFUZZ_CLOSED_T_MAX)";
  if (contact == 0) out += " || !claims(CCDFUZZ_CONTACT_AT_ZERO)";
  if (!is_of_bodies(query)) return out;
  const auto& [a, b] = query.patches;
  const Vec3<Rational> way = exact(a.velocities[0]) - exact(b.velocities[0]);
  Rational squared = dot(way, way), since = contact;
  const auto* apart =
      value.truth.clearance ? std::get_if<BodyClearance>(&*value.truth.clearance) : nullptr;
  if (apart != nullptr) {
    const Vec3<Rational> normal(apart->normal[0], apart->normal[1], apart->normal[2]);
    const Rational nearer = dot(normal, way);
    squared = nearer * nearer / dot(normal, normal);
    since = apart->until;
  }
  const double largest = largest_coordinate_at_ends(query);
  const double infinity = std::numeric_limits<double>::infinity();
  const double speed = std::nextafter(std::sqrt(round_up(squared)), infinity);
  if (!(speed < infinity && largest < infinity)) return out;
  return out + fmt::format(" ||\n              is_shallow(answer, {}, {}, t_max, {})",
                           to_hex(speed), to_hex(round_down(since)), to_hex(largest));
}

}  // namespace

std::string test_preamble(TestFramework framework) {
  const bool google = framework == TestFramework::kGoogleTest;
  std::string out =
      "// Written by ccdfuzz: what a plug-in answered wrong, as tests of it. Compile with the "
      "folder\n"
      "// of ccdfuzz_plugin.h in the include path, and link with the plug-in";
  out += google ? " and -lgtest_main -lgtest.\n" : " and Catch2's main.\n";
  out += "// The environment variable CCDFUZZ_PLUGIN_OPTIONS has the options of the plug-in.\n";
  return out + fmt::format(fmt::runtime(kPreamble), google ? kGoogleTestHeader : kCatch2Header);
}

Result<std::string> test_snippet(const NamedCase& named, size_t number, TestFramework framework) {
  const Case& value = named.value;
  if (const auto field = without_place(value.query)) {
    return input_error(fmt::format("{}: {}", named.id, *field),
                       "has no place in tests of a plug-in; replay asks the plug-in itself");
  }
  const Query& query = value.query;
  const Query moving = with_velocities(query).value_or(query);
  // A carriage return ends a comment, too.
  std::string out = fmt::format("\n// {}\n// {}\n", shown_line(named.id), truth_text(value));
  const std::string name = test_name(named.id, number);
  out += framework == TestFramework::kGoogleTest
             ? fmt::format("TEST(FoundByCcdfuzz, {}) {{\n", name)
             : fmt::format("TEST_CASE(\"found by ccdfuzz: {}\") {{\n", name);
  std::string patches;
  for (size_t side = 0; side < 2; ++side) {
    const MovingPatch<double>& patch = query.patches[side];
    const std::string letter = side == 0 ? "a" : "b";
    out += points_text("positions_" + letter, patch.positions);
    std::vector<std::string> rest(4, "nullptr");  // what the patch may have beside its positions
    if (const auto& velocities = moving.patches[side].velocities; !velocities.empty()) {
      out += points_text(rest[0] = "velocities_" + letter, velocities);
    }
    if (patch.has_ends()) out += points_text(rest[1] = "ends_" + letter, patch.ends);
    if (!patch.weights.empty()) out += weights_text(rest[2] = "weights_" + letter, patch.weights);
    const bool is_hull = patch.shape.kind == ShapeKind::kHull;
    if (is_hull) rest[3] = to_hex(patch.radius);
    while (rest.back() == "nullptr") rest.pop_back();
    patches += fmt::format(
        "  const ccdfuzz_patch {0} =\n"
        "      make_patch({1}, {2}, {3}, {4}, positions_{0}, {5});\n",
        letter, abi_name(patch.shape.kind), is_hull ? 0 : patch.shape.n, patch.shape.m,
        patch.positions.size(), fmt::join(rest, ", "));
  }
  out += patches;
  out += fmt::format("  const double t_max = {};\n", to_hex(query.t_max));
  const std::string separation = query.separation > 0 ? ", " + to_hex(query.separation) : "";
  out += fmt::format("  const ccdfuzz_answer answer = ask(a, b, t_max{});\n", separation);
  out += check_text(framework, "is_answer(answer, t_max)");
  const std::optional<Rational> contact = value.truth.contact_by();
  if (contact && *contact <= exact(query.t_max)) {
    const std::string excuse = excuse_text(value, *contact);
    out += check_text(framework, "answer.verdict != CCDFUZZ_MISS" + excuse);
    // toi > contact exactly if toi > the largest double that is not after it.
    out += fmt::format("  if (answer.verdict == CCDFUZZ_HIT) {{\n  {}  }}\n",
                       check_text(framework, fmt::format("is_in_time(answer, {}, t_max){}",
                                                         to_hex(round_down(*contact)), excuse)));
  } else if (is_proven_clear(value)) {
    out += check_text(framework, "answer.verdict != CCDFUZZ_HIT || may_be_near()");
  }
  return out + "}\n";
}

}  // namespace ccdfuzz
