#include "hunt/ground.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/nearest_float.hpp"
#include "case/body_motion.hpp"
#include "case/scale.hpp"
#include "certify/oracle/oracle.hpp"
#include "generators/bodies.hpp"
#include "generators/contact.hpp"
#include "method/method.hpp"
#include "method/plugin/plugin_spec.hpp"

namespace ccdfuzz {

namespace {

/// Shapes of degrees up to this are drawn where a method says how high they may be.
constexpr int kMostDrawn = 3;

/// Shapes of a kind, of this degree where it has one; of a tensor, also of one less in v.
std::vector<Shape> shapes_of(ShapeKind kind, int degree) {
  if (kind == ShapeKind::kPoint) return {Shape::point()};
  if (kind != ShapeKind::kTensor) return {{kind, degree, 0}};
  std::vector<Shape> shapes = {{kind, degree, degree}};
  if (degree > 1) shapes.push_back({kind, degree, degree - 1});
  return shapes;
}

bool is_pair_of_hulls(const Domain::Pair& pair) {
  return pair[0].shape == ShapeKind::kHull && pair[1].shape == ShapeKind::kHull;
}

/// The power of two that brings a magnitude well into [2^-scale, 2^scale], if it is not there. It
/// depends on the magnitude, so that what is drawn at all scales reaches all sizes of the range.
int shift_into(double magnitude, int scale) {
  const int exponent = magnitude == 0 ? 0 : std::ilogb(magnitude);
  if (-scale / 2 <= exponent && exponent < scale) return 0;
  return (exponent % scale + scale) % scale - scale / 2 - exponent;
}

/// A planted contact comes at t_max. Where numbers change it may come later, by less than this.
constexpr double kALittleLonger = 1.25;

/// Patches that go past 2^scale, by a little after t_max, lose the velocity of one of them, which
/// all share. If they still do, they become smaller, as far as they remain well above 2^-scale.
void slow_down(Query& query, int scale) {
  const auto farthest = [&] {
    Query longer = query;
    if (!has_ends(query)) longer.t_max *= kALittleLonger;
    return largest_coordinate_at_ends(longer);
  };
  const double most = std::ldexp(1.0, scale);
  if (!has_ends(query) && farthest() > most) {
    const Vec3<double> common = query.patches[0].velocities[0];
    for (MovingPatch<double>& patch : query.patches) {
      for (Vec3<double>& v : patch.velocities) v -= common;
    }
  }
  const double far = farthest();
  if (!(far > most) || !std::isfinite(far)) return;
  const int room = std::ilogb(std::max(largest_coordinate(query), 1 / most)) + scale / 2;
  scale_lengths(query, -std::min(std::ilogb(far) + 1 - scale, std::max(room, 0)));
}

/// The patches near the origin if they are far from it, and of other sizes and speeds.
void bring_to_scale(Query& query, int scale) {
  if (largest_coordinate(query) > std::ldexp(1.0, scale)) {
    const Vec3<double> origin = query.patches[0].positions[0];
    for (MovingPatch<double>& patch : query.patches) {
      for (Vec3<double>& p : patch.positions) p -= origin;
      for (Vec3<double>& p : patch.ends) p -= origin;
    }
  }
  if (!is_of_bodies(query)) slow_down(query, scale);
  scale_lengths(query, shift_into(largest_coordinate(query), scale));
  if (has_turns(query) || has_ends(query)) return;  // they move from 0 to 1
  const double fastest = std::max(largest_coordinate(query.patches[0].velocities),
                                  largest_coordinate(query.patches[1].velocities));
  const int in_time = shift_into(fastest, scale);
  for (MovingPatch<double>& patch : query.patches) {
    for (Vec3<double>& v : patch.velocities) v *= std::ldexp(1.0, in_time);
  }
  query.t_max = std::ldexp(query.t_max, -in_time);
  while (!stays_within(query, scale)) query.t_max /= 2;
}

}  // namespace

void scale_lengths(Query& query, int exponent) {
  for (MovingPatch<double>& patch : query.patches) {
    for_each_coordinate(patch, [&](double& x) { x = std::ldexp(x, exponent); });
  }
  query.separation = std::ldexp(query.separation, exponent);
}

const ShapePair& shapes_of_class(ContactClass contact) {
  const auto* const at = std::ranges::find(kLinearClasses, contact);
  return kLinearPairs.at(static_cast<size_t>(at - kLinearClasses.begin()));
}

std::optional<ContactClass> linear_class_of(const Query& query) {
  return linear_class_of(query.patches[0].shape, query.patches[1].shape);
}

std::optional<ContactClass> linear_class_of(const Shape& a, const Shape& b) {
  for (size_t i = 0; i < kLinearPairs.size(); ++i) {
    const auto& [first, second] = kLinearPairs[i];
    if ((a == first && b == second) || (a == second && b == first)) return kLinearClasses[i];
  }
  return std::nullopt;
}

bool HuntGround::has(const Query& query) const {
  const ShapePair of = {query.patches[0].shape, query.patches[1].shape}, swapped = {of[1], of[0]};
  return Domain::broken_by(query).empty() && order_of(query) &&
         (!shapes || of == *shapes || swapped == *shapes) && (!linear || linear_class_of(query)) &&
         (!bodies || is_of_bodies(query));
}

bool HuntGround::has(const Case& value) const {
  return has(value.query) && broken_by(value).empty();
}

bool HuntGround::has_shapes(const ShapePair& pair) const {
  Query query;
  for (size_t s = 0; s < 2; ++s) query.patches[s].shape = pair[s];
  return order_of(query).has_value();
}

bool HuntGround::are_linear() const {
  const std::vector<ShapePair> drawn = drawn_shapes();
  return !drawn.empty() && std::ranges::all_of(drawn, [](const ShapePair& pair) {
    return linear_class_of(pair[0], pair[1]).has_value();
  });
}

std::vector<ShapePair> HuntGround::drawn_shapes() const {
  std::vector<ShapePair> drawn;
  const auto add = [&](const ShapePair& pair) {
    if (has_shapes(pair) && std::ranges::find(drawn, pair) == drawn.end()) drawn.push_back(pair);
  };
  if (shapes) {
    add(*shapes), add({(*shapes)[1], (*shapes)[0]});
    return drawn;
  }
  if (linear) {
    for (const ShapePair& pair : kLinearPairs) add(pair);
    return drawn;
  }
  for (const Pair& pair : pairs) {
    for (int degree = 1; degree <= kMostDrawn; ++degree) {
      const auto side = [&](size_t s) {
        return shapes_of(pair[s].shape, std::min(degree, static_cast<int>(pair[s].max_degree)));
      };
      for (const Shape& first : side(0)) {
        for (const Shape& second : side(1)) add({first, second}), add({second, first});
      }
    }
  }
  return drawn;
}

double HuntGround::fitted(double x) const {
  constexpr auto kMost = static_cast<double>(std::numeric_limits<float>::max());
  if (scale && std::abs(x) < std::ldexp(1.0, -*scale)) return 0;
  return binary32 ? nearest_float(std::clamp(x, -kMost, kMost)) : x;
}

Case HuntGround::fitted(Case value) const {
  Query& query = value.query;
  const bool are_bodies = is_of_bodies(query);
  if (!is_decided_exactly(query) || Domain::broken_by(query).empty()) return value;
  const Query before = query;
  if (scale) bring_to_scale(query, *scale);
  const auto fit = [this](double& x) { x = fitted(x); };
  const double separation = binary32 ? nearest_float(query.separation) : query.separation;
  for_each_number(query, fit);
  if (!are_bodies) query.separation = separation;  // which may be small
  if (binary32 && are_bodies) {
    give_as_floats(query);
    for_each_number(query, fit);  // what has become small
  }
  for (MovingPatch<double>& patch : query.patches) {
    if (std::ranges::count(patch.weights, 0) > 0) patch.weights.clear();
    for (Points<double>* points : {&patch.positions, &patch.velocities}) {
      for (Vec3<double>& v : *points) v[2] = plane && are_bodies ? 0 : v[2];
    }
    if (patch.turn && plane) patch.turn->centre[2] = 0;
    if (patch.turn && plane && patch.turn->is_spin()) patch.turn->spin[0] = patch.turn->spin[1] = 0;
    if (patch.turn && fault_of(*patch.turn)) patch.turn.reset();  // what is left of it is none
  }
  if (query == before) return value;
  if (!are_bodies && !has_ends(query)) {
    const double until = query.t_max;
    for (const double factor : {2.0, kALittleLonger, 1.0}) {
      query.t_max = factor * until;
      if (binary32) query.t_max = nearest_float(query.t_max);
      if (scale) query.t_max = std::min(query.t_max, std::ldexp(1.0, *scale));
      if (!scale || stays_within(query, *scale)) break;
    }
  }
  const std::optional<Case> decided = decided_case(query);
  value.truth = decided ? decided->truth : Truth();
  value.origin.contact = decided ? decided->origin.contact : "";
  return value;
}

std::optional<Case> decided_case(const Query& query) {
  if (is_of_bodies(query)) return case_of_bodies(query);
  Case out;
  out.query = query;
  // Trees take long, and a case has no place for their bytes.
  out.truth = decide(query, {.max_tree_nodes = 0}).truth;
  if (!out.truth.collides) return std::nullopt;
  const std::optional<Contact> simple = contact_of(out);
  const auto contact = simple ? contact_class_of(*simple) : linear_class_of(query);
  if (contact) out.origin.contact = name_of(*contact);
  out.origin.kind = name_of(*out.truth.collides ? CaseKind::kRP : CaseKind::kRN);
  out.origin.generator = "mutant";
  return out;
}

namespace {

/// "bodies, floats": what is asked for.
std::string asked_text(const HuntGround& ground) {
  std::string text = ground.bodies ? "bodies" : ground.linear ? "linear patches" : "patches";
  if (ground.shapes) {
    text = fmt::format("{} against {}", to_text((*ground.shapes)[0]), to_text((*ground.shapes)[1]));
  }
  const std::string rules = ground.text();
  return rules.empty() ? text : text + ", " + rules;
}

/// "point and triangle(1), curve(1) and curve(1)": what a method takes.
std::string taken_text(const MethodInfo& info) {
  std::vector<std::string> texts = info.domain.pair_texts();
  if (texts.empty())
    texts.emplace_back(takes_bodies(info.features) ? "patches and bodies" : "patches");
  if (std::string rules = info.domain.text(); !rules.empty()) texts.push_back(std::move(rules));
  return fmt::format("{}", fmt::join(texts, ", "));
}

}  // namespace

Result<HuntGround> narrowed(HuntGround ground, const std::vector<std::string>& methods) {
  const auto nothing = [&, asked = asked_text(ground)]() -> Result<HuntGround> {
    if (methods.size() > 1) {
      return input_error("methods", "no query is taken by all of {}: hunt them apart",
                         fmt::join(methods, ", "));
    }
    CCDFUZZ_TRY(const MethodInfo info, method_info(methods.front()));
    return input_error("methods", "{} takes no query of those that are asked for ({}): it takes {}",
                       methods.front(), asked, taken_text(info));
  };
  bool take_bodies = true, take_patches = true, means_bodies = false;
  bool take_convex = true, take_meshes = !ground.uniform, take_one_sided = !ground.uniform;
  for (const std::string& method : methods) {
    CCDFUZZ_TRY(const MethodInfo info, method_info(method));
    const Domain& domain = info.domain;
    std::optional<Domain> both = ground.with(domain);
    if (!both) return nothing();
    static_cast<Domain&>(ground) = *std::move(both);
    const auto& pairs = domain.pairs;
    take_convex = take_convex && info.features.bodies;
    take_meshes = take_meshes && info.features.meshes;
    take_one_sided = take_one_sided && info.features.one_sided;
    take_bodies = take_bodies && (take_convex || take_meshes || take_one_sided) &&
                  (pairs.empty() || std::ranges::any_of(pairs, is_pair_of_hulls));
    // Who takes bodies, names no shapes and limits the rest is an adapter of an engine.
    means_bodies = means_bodies || (takes_bodies(info.features) && pairs.empty() &&
                                    names_plugin(method) && !domain.text().empty());
    take_patches = take_patches && (pairs.empty() || !std::ranges::all_of(pairs, is_pair_of_hulls));
  }
  const bool is_of_patches = ground.linear || ground.shapes;
  const bool is_of_bodies = !take_patches || (means_bodies && take_bodies);
  if (is_of_bodies && !is_of_patches) ground.bodies = true;
  if (ground.bodies ? !take_bodies : !take_patches) return nothing();
  const bool had_pairs = !ground.pairs.empty();
  std::erase_if(ground.pairs,
                [&](const Domain::Pair& pair) { return is_pair_of_hulls(pair) != ground.bodies; });
  const auto is_on = [&](const ShapePair& pair) { return ground.has_shapes(pair); };
  const auto has_some = [&](ContactClass contact) {
    return has_bodies(ground.body_kinds, contact);
  };
  const bool is_drawn = ground.bodies
                            ? std::ranges::any_of(kContactClasses, has_some)
                            : (!is_of_patches || !ground.drawn_shapes().empty()) &&
                                  (!ground.uniform || std::ranges::any_of(kLinearPairs, is_on)) &&
                                  (!ground.shapes || is_on(*ground.shapes));
  if (!is_drawn || (had_pairs && ground.pairs.empty())) return nothing();
  return ground;
}

}  // namespace ccdfuzz
