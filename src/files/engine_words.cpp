#include "files/engine_words.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/nearest_float.hpp"
#include "base/read_double.hpp"
#include "numeric/exact_scalars.hpp"

namespace ccdfuzz {

namespace {

/// A float in the fewest digits that are read as it.
std::string short_text(double x) {
  return is_float(x) ? fmt::format("{}", static_cast<float>(x)) : fmt::format("{}", x);
}

EngineBody as_it_is(const MovingPatch<double>& patch) {
  return {patch.positions, {0, 0, 0}, patch.radius, {}, patch.faces};
}

EngineBody about_its_middle(const MovingPatch<double>& patch) {
  EngineBody body = as_it_is(patch);
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
    for (int k = 0; k < 3; ++k) {
      is_exact = is_exact && is_float(middle[k]) && is_float(about.back()[k]) &&
                 exact(about.back()[k]) + exact(middle[k]) == exact(p[k]);
    }
  }
  if (!is_exact && about.size() > 1) return body;
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

/// w, x, y, z of the rotation from an axis into the direction of a capsule about 0, or into the
/// opposite one: none of its ends is the first.
std::vector<double> turn_of_capsule(const Vec3<double>& end, int axis) {
  const Vec3<double> to = end / (end[axis] < 0 ? -end.norm() : end.norm());
  std::vector<double> turn = {1 + to[axis], 0, 0, 0};
  turn[static_cast<size_t>(1 + (axis + 1) % 3)] = -to[(axis + 2) % 3];
  turn[static_cast<size_t>(1 + (axis + 2) % 3)] = to[(axis + 1) % 3];
  const double length = std::hypot(std::hypot(turn[0], turn[1]), std::hypot(turn[2], turn[3]));
  for (double& x : turn) x = nearest_float(x / length);
  return turn;
}

/// The length of a quaternion, or of cosine and sine, is 1 but for rounding to floats.
bool is_unit(const std::vector<double>& q) {
  double squared = 0;
  for (const double x : q) squared += x * x;
  return std::abs(squared - 1) <= 0x1p-20;
}

}  // namespace

std::string list(const Vec3<double>& v) {
  return fmt::format("{}, {}, {}", v[0], v[1], v[2]);
}

std::string filled(std::string text, const std::map<std::string_view, std::string>& words) {
  for (const auto& [name, word] : words) {
    for (size_t at = text.find(name); at != text.npos; at = text.find(name, at + word.size())) {
      text.replace(at, name.size(), word);
    }
  }
  return text;
}

std::string without_idle_helpers(std::string text) {
  constexpr std::string_view kMark = "//: ", kEnd = "//:\n";
  for (size_t at = text.find(kMark); at != text.npos; at = text.find(kMark, at)) {
    const size_t line = text.find('\n', at), end = text.find(kEnd, line);
    const std::string call = text.substr(at + kMark.size(), line - at - kMark.size()) + "(";
    const bool is_called = text.find(call, end) != text.npos;
    text.erase(end, kEnd.size());
    text.erase(at, (is_called ? line + 1 : end) - at);
  }
  return text;
}

EngineWords::EngineWords(const EngineTemplate& of, bool of_meshes)
    : engine(of.engine), ending(of.ending) {
  std::string_view file = of_meshes && !of.mesh_text.empty() ? of.mesh_text : of.text;
  constexpr std::string_view kMark = "//= ";
  while (file.starts_with(kMark)) {
    const std::string_view line = file.substr(kMark.size(), file.find('\n') - kMark.size());
    const size_t colon = line.find(": ");
    names.emplace(line.substr(0, colon),
                  filled(std::string(line.substr(colon + 2)), {{"\\n", "\n"}}));
    file.remove_prefix(kMark.size() + line.size() + 1);
  }
  text = file;
}

std::optional<std::string> EngineWords::word(std::string_view name) const {
  const auto found = names.find(name);
  return found == names.end() ? std::nullopt : std::optional(found->second);
}

double EngineWords::number(std::string_view name) const {
  double x = 0;
  const std::string of = word(name).value_or("");
  read_double(of.data(), of.data() + of.size(), x);
  return x;
}

std::string EngineWords::list(const Points<double>& points) const {
  std::vector<std::string> texts;
  for (const Vec3<double>& p : points) {
    texts.push_back(filled(names.at("point"), {{"*", ccdfuzz::list(p)},
                                               {"__X__", fmt::format("{}", p[0])},
                                               {"__Y__", fmt::format("{}", p[1])}}));
  }
  return fmt::format("{}", fmt::join(texts, ", "));
}

std::string EngineWords::rotation(const std::vector<double>& q) const {
  std::string one = word("rotation").value_or("");
  for (size_t i = 0; i < q.size(); ++i) {
    one = filled(one, {{fmt::format("__{}__", i), short_text(q[i])}});
  }
  return one;
}

std::optional<EngineWords::Shaped> EngineWords::shape(const std::string& name,
                                                      const MovingPatch<double>& patch,
                                                      const EngineBody& body) const {
  const std::optional<std::string> of = word(name);
  if (!of) return std::nullopt;
  std::vector<std::string> numbers, corners;
  for (const Vec3<double>& p : body.points) numbers.push_back(ccdfuzz::list(p));
  for (const Face& face : body.faces) corners.push_back(fmt::format("{}", fmt::join(face, ", ")));
  const Vec3<double> half = body.half.value_or(Vec3<double>(0, 0, 0));
  EngineBody shaped = body;
  if (name == "round segment" && has("capsule axis")) {
    if (body.points[0] != -body.points[1]) return std::nullopt;  // its middle is no float
    shaped.turn = turn_of_capsule(body.points[1], static_cast<int>(number("capsule axis")));
  }
  const Vec3<double> centre = patch.turn ? patch.turn->centre : Vec3<double>(0, 0, 0);
  return Shaped{shaped,
                filled(*of, {{"__POINTS__", list(body.points)},
                             {"__NUMBERS__", fmt::format("{}", fmt::join(numbers, ", "))},
                             {"__COUNT__", fmt::format("{}", body.points.size())},
                             {"__RADIUS__", fmt::format("{}", body.radius)},
                             {"__HALF__", ccdfuzz::list(half)},
                             {"__HALF_LENGTH__", short_text(nearest_float(body.points[0].norm()))},
                             {"__SIZE__", ccdfuzz::list(Vec3<double>(2 * half))},
                             {"__FACE_COUNT__", fmt::format("{}", body.faces.size())},
                             {"__FACES__", fmt::format("{}", fmt::join(corners, ", "))},
                             {"__CENTRE__", list({centre})}})};
}

std::optional<EngineWords::Shaped> EngineWords::shape(const MovingPatch<double>& patch) const {
  constexpr std::array kKinds = {"point", "segment", "triangle", "hull"};
  const EngineBody body = about_its_middle(patch), raw = as_it_is(patch);
  if (!patch.faces.empty()) {
    return shape("mesh", patch, has("any") ? raw : body);
  }
  const std::string round = body.radius > 0 ? "round " : "";
  const std::string kind = kKinds[std::min(body.points.size(), kKinds.size()) - 1];
  std::optional<Shaped> shaped;
  if (body.half) shaped = shape(round + ((*body.half)[2] > 0 ? "box" : "flat box"), patch, body);
  // "point" alone is how a point of a body is written.
  if (!shaped && round + kind != "point") shaped = shape(round + kind, patch, body);
  if (!shaped && patch.turn) shaped = shape("turned any", patch, raw);
  if (!shaped) shaped = shape("any", patch, raw);
  if (!shaped) shaped = shape(fmt::format("{}{} points", round, raw.points.size()), patch, raw);
  return shaped;
}

std::optional<std::string> EngineWords::sweep(const MovingPatch<double>& patch,
                                              const EngineBody& body, double step) const {
  const Vec3<double> way = step * patch.velocities[0];
  const std::string origin = list({body.centre});
  if (!patch.turn) {
    return filled(word("still").value_or(""),
                  {{"__ORIGIN__", origin}, {"__END__", list({body.centre + way})}});
  }
  const BodyTurn& turn = *patch.turn;
  std::map<std::string_view, std::string> words = {{"__ORIGIN__", origin},
                                                   {"__CENTRE__", list({turn.centre})},
                                                   {"__END__", list({turn.centre + way})}};
  if (turn.is_spin()) {
    const Vec3<double> axis(turn.spin[0], turn.spin[1], turn.spin[2]);
    const double angle = (has("plane") ? axis[2] : axis.norm()) * step;
    words.emplace("__AXIS__", list({axis}));
    words.emplace("__ANGLE__", fmt::format("{}", angle));
    // As an adapter has it (spun), to the last bit: no function of the engine rounds it anew.
    const double speed = axis.norm();
    const Vec3<double> part = speed > 0 ? std::sin(speed * step / 2) / speed * axis : axis;
    words.emplace("__TURNED__",
                  fmt::format("{}, {}, {}, {}", part[0], part[1], part[2], std::cos(angle / 2)));
    const std::optional<std::string> of = word("spin");
    return of ? std::optional(filled(*of, words)) : std::nullopt;
  }
  const bool has_four = word("rotation").value_or("").find("__3__") != std::string::npos;
  if (!has("turn") || has_four != turn.is_quaternion()) return std::nullopt;
  if (!is_unit(turn.from) || !is_unit(turn.to)) return std::nullopt;
  words.emplace("__FROM__", rotation(turn.from));
  words.emplace("__TO__", rotation(turn.to));
  return filled(names.at("turn"), words);
}

}  // namespace ccdfuzz
