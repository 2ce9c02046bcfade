#include "files/test_snippet.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "base/text.hpp"
#include "case/judge.hpp"
#include "case/scale.hpp"
#include "files/engine_words.hpp"
#include "numeric/products.hpp"

namespace ccdfuzz {

namespace {

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

/// "{a, b, c}".
std::string numbers_text(const auto& numbers) {
  std::vector<std::string> texts;
  for (const double x : numbers) texts.push_back(to_hex(x));
  return fmt::format("{{{}}}", fmt::join(texts, ", "));
}

/// An array of rows of so many numbers.
std::string rows_text(const std::string& name, int size, const auto& rows) {
  std::vector<std::string> texts;
  for (const auto& row : rows) texts.push_back(numbers_text(row));
  return fmt::format("  const double {}[][{}] = {{\n      {}}};\n", name, size,
                     fmt::join(texts, ",\n      "));
}

std::string loops_text(const std::string& letter, const Trim& trim) {
  std::vector<size_t> sizes;
  std::vector<Uv<double>> vertices;
  for (const auto& loop : trim) {
    sizes.push_back(loop.size());
    vertices.insert(vertices.end(), loop.begin(), loop.end());
  }
  return fmt::format("  const std::uint64_t loop_sizes_{}[] = {{{}}};\n{}", letter,
                     fmt::join(sizes, ", "), rows_text("loops_" + letter, 2, vertices));
}

std::string check_text(TestFramework framework, const std::string& condition) {
  // Without its own parentheses Catch2 takes a condition apart, and refuses "||".
  return framework == TestFramework::kGoogleTest ? fmt::format("  EXPECT_TRUE({});\n", condition)
                                                 : fmt::format("  CHECK(({}));\n", condition);
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

/// What a contact is.
std::string contact_words(const Query& query) {
  return query.separation > 0 ? fmt::format("they are {} apart or less", query.separation)
                              : "they touch";
}

/// What is proven, for people.
std::string truth_text(const Case& value) {
  const Truth& truth = value.truth;
  const std::string touch = contact_words(value.query);
  if (truth.witness && truth.collides == true && !is_of_bodies(value.query)) {
    const auto& uv = truth.witness->uv;
    return fmt::format("{} at t = {}, (u, v) = ({}, {}) and ({}, {}), exactly", touch,
                       to_text(truth.witness->t), to_text(uv[0][0]), to_text(uv[0][1]),
                       to_text(uv[1][0]), to_text(uv[1][1]));
  }
  if (truth.collides == true) return touch + " by t = " + to_text(*truth.contact_by());
  if (is_proven_clear(value)) {
    return fmt::format("nothing {} in [0, t_max]",
                       value.query.separation > 0 ? "comes so near" : "touches");
  }
  return "nothing is proven of contacts: an answer is all that is wanted";
}

/// The same in numbers that compare with those of an answer.
std::string contact_text(const Case& value) {
  const std::optional<Rational> by = value.truth.contact_by();
  if (!by || *by > exact(value.query.t_max)) return truth_text(value);
  const double t = round_up(*by);
  return fmt::format("{} by t = {} ({})", contact_words(value.query), t, to_hex(t));
}

/// What these tests have no place for; nothing if a query has none of it.
std::optional<std::string> without_place(const Query& query) {
  for (size_t side = 0; side < 2; ++side) {
    const MovingPatch<double>& patch = query.patches[side];
    const char* field = !patch.faces.empty()    ? "faces"
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
  const auto* apart = clearance_of<BodyClearance>(value.truth);
  if (apart != nullptr) {
    const Rational nearer = dot(apart->normal, way);
    squared = nearer * nearer / dot(apart->normal, apart->normal);
    since = apart->until;
  }
  const double largest = largest_coordinate_at_ends(query);
  const double infinity = std::numeric_limits<double>::infinity();
  const double speed = std::nextafter(std::sqrt(round_up(squared)), infinity);
  if (!(speed < infinity && largest < infinity)) return out;
  return out + fmt::format(" ||\n              is_shallow(answer, {}, {}, t_max, {})",
                           to_hex(speed), to_hex(round_down(since)), to_hex(largest));
}

/// The check of the separation that a plug-in may claim, of patches that are proven to touch at
/// some time. None if that is at 0, or where doubles cannot say it.
std::string separation_check(const Case& value, TestFramework framework) {
  const std::optional<Approach> approach = approach_of(value);
  if (!approach) return "";
  const double infinity = std::numeric_limits<double>::infinity();
  const double distance = std::nextafter(std::sqrt(round_up(approach->squared)), infinity);
  const double contact = round_up(approach->until);
  if (!(0 < contact && contact < infinity && distance < infinity)) return "";
  return check_text(framework, fmt::format("keeps_separation(answer, {}, {}, t_max)",
                                           to_hex(distance), to_hex(contact)));
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
  return out + filled(std::string(plugin_test_template()),
                      {{"__FRAMEWORK__", google ? kGoogleTestHeader : kCatch2Header}});
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
    out += rows_text("positions_" + letter, 3, patch.positions);
    std::vector<std::string> rest(4, "nullptr");  // what the patch may have beside its positions
    if (const auto& velocities = moving.patches[side].velocities; !velocities.empty()) {
      out += rows_text(rest[0] = "velocities_" + letter, 3, velocities);
    }
    if (patch.has_ends()) out += rows_text(rest[1] = "ends_" + letter, 3, patch.ends);
    if (!patch.weights.empty()) {
      out += fmt::format("  const double {}[] = {};\n", rest[2] = "weights_" + letter,
                         numbers_text(patch.weights));
    }
    const bool is_hull = patch.shape.kind == ShapeKind::kHull;
    if (is_hull) rest[3] = to_hex(patch.radius);
    while (rest.back() == "nullptr") rest.pop_back();
    std::string made =
        fmt::format("make_patch({}, {}, {}, {}, positions_{}, {})", abi_name(patch.shape.kind),
                    is_hull ? 0 : patch.shape.n, patch.shape.m, patch.positions.size(), letter,
                    fmt::join(rest, ", "));
    if (!patch.trim.empty()) {
      out += loops_text(letter, patch.trim);
      made = fmt::format("trimmed({0},\n              {1}, loop_sizes_{2}, loops_{2})", made,
                         patch.trim.size(), letter);
    }
    patches += fmt::format("  const ccdfuzz_patch {} =\n      {};\n", letter, made);
  }
  out += patches;
  out += fmt::format("  const double t_max = {};\n", to_hex(query.t_max));
  const std::string separation = query.separation > 0 ? ", " + to_hex(query.separation) : "";
  out += fmt::format("  const ccdfuzz_answer answer = ask(a, b, t_max{});\n", separation);
  const std::optional<Rational> contact = value.truth.contact_by();
  out += fmt::format("  {}(answered(answer) + \"; {}\");\n",
                     framework == TestFramework::kGoogleTest ? "SCOPED_TRACE" : "INFO",
                     contact_text(value));
  out += check_text(framework, "is_answer(answer, t_max)");
  out += separation_check(value, framework);
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
