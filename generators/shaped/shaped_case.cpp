#include "generators/shaped/shaped_case.hpp"

#include "generators/finalize.hpp"
#include "generators/first_contact.hpp"
#include "generators/shaped/families.hpp"

namespace ccdfuzz {

namespace {

constexpr ShapePair kTwoQuadratics = {Shape::triangle(2), Shape::triangle(2)};

/// True iff a one-sided patch of this shape touches the contact plane in one point only.
bool touches_in_one_point(const Shape& shape, Feature feature) {
  const bool curved = shape.n >= 2 && (shape.kind != ShapeKind::kTensor || shape.m >= 2);
  return feature == Feature::kCorner || curved;
}

/// Errors: of these shapes no such contact is made, saying of which patch if it is one's fault.
Result<void> check_shapes(const GeneratorOptions& options, const ShapePair& shapes) {
  constexpr std::array<std::string_view, 3> kNames = {"face", "edge", "corner"};
  const std::array<Feature, 2> features = features_of(options.contact);
  for (size_t s = 0; s < 2; ++s) {
    const std::string shape = to_text(shapes[s]);
    if (!shapes[s].valid()) {
      return input_error("shape", "{} has a degree outside 1..{}", shape, kMaxDegree);
    }
    if (!has_feature(shapes[s], features[s])) {
      return input_error("shape", "patch {} of {} has a {}, and {} has none", s + 1,
                         name_of(options.contact), kNames[static_cast<size_t>(features[s])], shape);
    }
    if (is_grazing(options.kind) && !touches_in_one_point(shapes[s], features[s])) {
      return input_error("shape", "{} of {} needs degrees of 2 or more, not {}",
                         name_of(options.kind), name_of(options.contact), shape);
    }
  }
  const FamilyRow& row = row_of(options.family);
  if (row.fits != nullptr && !row.fits(options.contact, shapes)) {
    return input_error("shape", "{} and {} have no contact {} of {}", to_text(shapes[0]),
                       to_text(shapes[1]), name_of(options.family), name_of(options.contact));
  }
  return {};
}

PlacedScene scene_of(const GeneratorOptions& options, const ShapePair& shapes, Draw& draw) {
  if (is_grazing(options.kind)) {
    return grazing_variant(options.kind == CaseKind::kNMN, options.contact, shapes, draw);
  }
  const auto make = std::get<FamilyRow::Make*>(row_of(options.family).made_by);
  return make(options.contact, shapes, draw);
}

}  // namespace

ShapePair shapes_of(const GeneratorOptions& options, Draw& draw) {
  if (options.shapes) return *options.shapes;
  if (options.family <= Family::kInteriorTime) return kTwoQuadratics;
  const std::array<Feature, 2> features = features_of(options.contact);
  return draw.until(
      [&] {
        ShapePair shapes;
        for (size_t s = 0; s < 2; ++s) shapes[s] = random_shape(features[s], draw);
        if (options.family == Family::kArea) shapes[0] = shapes[1];
        return shapes;
      },
      [&](const ShapePair& shapes) { return check_shapes(options, shapes).has_value(); });
}

Attempted as_asked(Case positive, const GeneratorOptions& options) {
  if (options.kind != CaseKind::kRN) return positive;
  if (!positive.truth.clear_until) return tl::unexpected(Discard::kFirstContact);
  positive.truth.clear_until = positive.truth.witness->t - eps_t(options).rational();
  const auto t_max = to_double_exactly(*positive.truth.clear_until);
  if (!t_max) return tl::unexpected(Discard::kRoundTrip);
  say_clear(positive, *t_max);
  return positive;
}

bool is_shaped(const GeneratorOptions& options) {
  if (has_own_shapes(options.family)) return false;
  const bool is_paper =
      options.family == Family::kRegular && options.construction == Construction::kPaper;
  const bool is_quadratic = options.shapes.value_or(kTwoQuadratics) == kTwoQuadratics;
  return !(is_paper || options.family == Family::kTwins) || !is_quadratic;
}

Result<void> validate_shaped(const GeneratorOptions& options) {
  if (options.family == Family::kTwins) {
    return input_error("shape", "the family {} has no shapes but triangle:2",
                       name_of(options.family));
  }
  if (options.family == Family::kRegular && options.construction == Construction::kPaper) {
    return input_error("construction", "paper makes patches of shape triangle:2 only");
  }
  return options.shapes ? check_shapes(options, *options.shapes) : Result<void>();
}

Attempted shaped_case(const GeneratorOptions& options, Draw& draw) {
  const PlacedScene made = scene_of(options, shapes_of(options, draw), draw);
  std::optional<Case> value = to_case(made.scene, made.placement, draw);
  if (!value) return tl::unexpected(Discard::kRoundTrip);
  const Dyadic before = made.scene.t - eps_t(options);
  switch (options.kind) {
    case CaseKind::kRP:
    case CaseKind::kRN:
      return as_asked(*std::move(value), options);
    case CaseKind::kNHP:
      if (!proven_by_search(value->query, before, options.proof_pops))
        return tl::unexpected(Discard::kFirstContact);
      value->truth.clear_until = before.rational();
      break;
    case CaseKind::kNMN:
      return proven_apart(*std::move(value), options);
  }
  return *std::move(value);
}

Attempted plain_case(Family family, const GeneratorOptions& options, Draw& draw) {
  GeneratorOptions plain = options;
  plain.family = family;
  plain.kind = CaseKind::kRP;
  plain.shapes = shapes_of(options, draw);
  return shaped_case(plain, draw);
}

}  // namespace ccdfuzz
