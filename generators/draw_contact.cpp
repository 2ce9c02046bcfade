#include "generators/draw_contact.hpp"

#include <algorithm>
#include <cmath>

#include "bezier/blossom.hpp"
#include "bezier/exact_patch.hpp"
#include "generators/draw_patch.hpp"
#include "generators/elsewhere.hpp"
#include "generators/shaped/contact_scene.hpp"

namespace ccdfuzz {

namespace {

constexpr int kContactUvBits = 2;
/// A control point has so many bits at a contact whose parameters are off the grid.
constexpr int kOffGridBits = 32;
/// The same of a float, which then has a few left for the place and the frame. A time that is off
/// the grid has kFloatTimeBits after the point, to which a velocity adds its own.
constexpr int kFloatOffGridBits = 15, kFloatTimeBits = 12;
constexpr int kTwinUlps = 2;

/// For each control point, whether its Bernstein weight at the contact is not 0.
std::vector<bool> bearing_controls(const ContactSide& side) {
  std::vector<bool> bearing;
  for_each_control(side.shape,
                   [&](int i, int j) { bearing.push_back(bears(side.shape, side.at, i, j)); });
  return bearing;
}

/// Patch 1 is to lie above the plane, patch 2 below.
ContactSide draw_side(Draw& choices, const ContactRange& range, std::size_t place) {
  constexpr int kSpeedBits = 5;
  constexpr long kSpeedUnit = -3;
  const long unit = 3 - range.coordinate_bits;
  const Dyadic outward(place == 0 ? 1 : -1);
  ContactSide side;
  side.shape = range.shapes ? range.shapes->at(place) : draw_shape(choices, range.max_degree);
  // Each degree takes the bits of the parameters once more.
  const int degrees = std::max(1, side.shape.n + side.shape.m);
  const bool off_grid = range.off_grid && choices.coin();
  const int bits_in_all = range.binary32 ? kFloatOffGridBits : kOffGridBits;
  const int left = (bits_in_all - range.coordinate_bits) / degrees;
  side.at = off_grid ? draw_fine_uv(choices, side.shape, std::max(kContactUvBits, left))
                     : draw_uv(choices, side.shape, kContactUvBits);
  side.points = draw_points(choices, side.shape, range.coordinate_bits, unit);
  side.rates = draw_points(choices, side.shape, kSpeedBits, kSpeedUnit);
  const std::vector<bool> bearing = bearing_controls(side);
  const bool one_sided = !choices.coin();
  for (std::size_t i = 0; one_sided && i < side.points.size(); ++i) {
    side.points[i][2] = bearing[i] ? Dyadic() : outward * abs(side.points[i][2]);
    side.rates[i][2] = -outward * abs(side.rates[i][2]);
  }
  const Vec3<Dyadic> at_contact = evaluate<Dyadic>(side.shape, side.points, side.at);
  for (Vec3<Dyadic>& p : side.points) p -= at_contact;
  return side;
}

/// Makes some control points that do not bear on the contact equal to the one before, up to ulps.
void draw_twins(Draw& choices, const ContactSide& side, int ulps, MovingPatch<double>& patch) {
  const std::vector<bool> bearing = bearing_controls(side);
  for (std::size_t i = 1; i < patch.positions.size(); ++i) {
    if (bearing[i] || !choices.coin()) continue;
    for (int k = 0; k < 3; ++k) {
      patch.positions[i][k] = choices.nudged(patch.positions[i - 1][k], ulps);
      patch.velocities[i][k] = choices.nudged(patch.velocities[i - 1][k], ulps);
    }
  }
}

Result<void> refuse_unless_in(const std::string& field, int value, int lo, int hi) {
  if (lo <= value && value <= hi) return {};
  return input_error(field, "{} is not in [{}, {}]", value, lo, hi);
}

}  // namespace

Result<void> validate(const ContactRange& range) {
  constexpr int kMostBits = 40, kMostScale = 1000;
  CCDFUZZ_TRY_VOID(refuse_unless_in("max_degree", range.max_degree, 1, kMaxDegree));
  CCDFUZZ_TRY_VOID(refuse_unless_in("coordinate_bits", range.coordinate_bits, 0, kMostBits));
  CCDFUZZ_TRY_VOID(refuse_unless_in("lowest", range.lowest, -kMostScale, kMostScale));
  CCDFUZZ_TRY_VOID(refuse_unless_in("highest", range.highest, range.lowest, kMostScale));
  CCDFUZZ_TRY_VOID(refuse_unless_in("most_drift", range.most_drift, -3, kMostScale));
  if (!range.shapes) return {};
  for (const Shape& shape : *range.shapes) {
    if (shape.valid() && shape.kind != ShapeKind::kHull) continue;
    return input_error("shapes", to_text(shape) + " is no patch of degrees from 1 to 8");
  }
  return {};
}

Result<Case> draw_contact(Draw& choices, const ContactRange& range) {
  Placement placement;
  placement.exponent.fill(choices.integer(range.lowest, range.highest));
  placement.frame = draw_frame_near_axes(choices, 2);
  Vec3<Dyadic> contact;
  for (int k = 0; k < 3; ++k) contact[k] = choices.dyadic(8, -3);
  const long common_exponent = choices.integer(-3, range.most_drift);
  for (int k = 0; k < 3; ++k) placement.drift[k] = choices.dyadic(3, common_exponent);
  Dyadic t = choices.pick(std::array{Dyadic(1), Dyadic(1, -1), Dyadic(3, -2), Dyadic()});
  if (range.off_grid && choices.coin()) {
    const Dyadic off(choices.integer(-7, 7), range.binary32 ? -kFloatTimeBits : -43);
    t = abs(t + off);
  }
  placement.shift = contact - placement.drift * t;

  Case drawn;
  drawn.truth.collides = true;
  drawn.truth.witness.emplace();
  drawn.truth.witness->t = t.rational();
  for (std::size_t s = 0; s < 2; ++s) {
    const ContactSide side = draw_side(choices, range, s);
    MovingPatch<Dyadic> exactly = placed(side, placement, t);
    exactly.positions = exactly.at(-t);
    auto patch = to_doubles(exactly);
    if (!patch) return input_error("", "a number is not a double");
    if (choices.coin()) draw_twins(choices, side, range.binary32 ? 0 : kTwinUlps, *patch);
    drawn.query.patches[s] = *std::move(patch);
    drawn.truth.witness->uv[s] = {side.at[0].rational(), side.at[1].rational()};
  }
  const double t_contact = *t.to_double_exactly();
  const double little = range.binary32 ? 0x1p-20 : 0x1p-30;
  drawn.query.t_max = choices.pick(std::array{t_contact, t_contact + little, t_contact + 0.5, 2.0});
  drawn.origin.generator = "draw_contact";
  if (!range.elsewhere || !choices.coin()) return drawn;
  return elsewhere(drawn, choices);
}

Contact draw_witnessed(Draw& choices, const ContactRange& range) {
  return *choices.until(
      [&] {
        const Result<Case> drawn = draw_contact(choices, range);
        return drawn ? contact_of(*drawn) : std::nullopt;
      },
      [](const std::optional<Contact>& contact) { return contact.has_value(); });
}

double draw_double_near(Draw& choices, const Rational& near) {
  const double x = choices.nudged(round_down(near), 2);
  const int exponent = choices.pick(std::array{0, 0, 0, -1, 1});
  return std::max(0.0, std::ldexp(x, exponent));
}

GeneratorOptions draw_regular_options(Draw& choices) {
  GeneratorOptions options;
  options.construction = Construction::kOneSided;
  options.contact = choices.pick(kContactClasses);
  options.kind = choices.pick(kCaseKinds);
  options.seed = choices.choose(~std::uint64_t{0});
  // Enough for every other grazing case of quadratic triangles, and for nearly all others. So
  // many pops take 50 ms for tensor patches. With the default, one input took two seconds, and a
  // minute under sanitizers.
  options.proof_pops = 1000;
  if (choices.coin()) {
    constexpr int kMostDegree = 3;
    const Shape first = draw_shape(choices, kMostDegree);
    options.shapes = {first, draw_shape(choices, kMostDegree)};
    if (!validate(options)) options.shapes.reset();
  }
  return options;
}

GeneratorOptions draw_generator_options(Draw& choices) {
  const Family family = choices.pick(kFamilies);
  GeneratorOptions options = draw_regular_options(choices);
  if (family == Family::kRegular || !is_made(family, options.contact, CaseKind::kRP))
    return options;
  options.family = family;
  if (validate(options)) return options;
  options.shapes.reset();
  if (!is_made(family, options.contact, options.kind)) options.kind = CaseKind::kRP;
  return options;
}

Case draw_generated(Draw& choices) {
  constexpr std::uint64_t kRare = 31;
  GeneratorOptions options = draw_generator_options(choices);
  const bool rare = choices.choose(kRare) == kRare;
  if (options.kind == CaseKind::kNHP && !options.shapes && !rare) options.kind = CaseKind::kRP;
  return generate(options, 0).value;
}

}  // namespace ccdfuzz
