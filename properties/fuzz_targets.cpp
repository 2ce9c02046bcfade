#include "properties/fuzz_targets.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>

#include "properties/registry.hpp"

namespace ccdfuzz {

namespace {

constexpr auto kAnyBits = std::to_array<std::string_view>({
    "methods.refuses_invalid",
    "query.is_valid",
});

constexpr auto kArithmetic = std::to_array<std::string_view>({
    "dyadic.round_trip",
    "wide_int.is_gmp",
    "bounded_int.is_gmp",
    "double.parts",
    "double.exact_sums",
    "double.exact_in_any_environment",
    "rational.rounding",
    "paper.rounding",
    "paper.nextafter_bounds",
    "number.texts",
});

constexpr auto kCaseReader = std::to_array<std::string_view>({
    "case_file.any_bytes",
});

constexpr auto kCertificates = std::to_array<std::string_view>({
    "checker.refuses_malformed_trees",
    "checker.refuses_touching_leaves",
    "checker.refuses_changed_planes",
    "checker.refuses_changed_boxes",
    "checker.refuses_moved_contacts",
    "checker.refuses_contacts_after_t_max",
    "checker.refuses_clearance_past_a_contact",
    "checker.refuses_wrong_claims",
    "checker.refuses_proofs_before_start",
    "checker.refuses_wrong_trees",
    "checker.refuses_wrong_planes",
    "checker.refuses_wrong_boxes",
    "checker.refuses_wrong_texts",
    "checker.refuses_wrong_witnesses",
    "checker.refuses_wrong_linear_clearances",
    "checker.refuses_wrong_roots",
    "checker.same_in_any_environment",
    "checker.decides_quadratics",
    "checker.refuses_negative_polynomials",
    "checker.sees_nonnegative_rows",
    "miss_tree.round_trip",
});

constexpr auto kGenerators = std::to_array<std::string_view>({
    "generator.coincidence",
    "generator.tangency",
    "generator.extraction",
    "generator.motion",
    "generator.first_contact",
    "generator.cases",
    "generator.other_contacts",
    "generator.grazing",
    "generator.grazing_shapes",
    "generator.clearance",
    "generator.refuses_planes",
});

constexpr auto kJudge = std::to_array<std::string_view>({
    "judge.sees_misses_and_late_answers",
    "judge.sees_false_positives",
    "judge.keeps_to_terms_of_time",
    "judge.keeps_to_terms_of_space",
    "judge.believes_nothing_unproven",
});

constexpr auto kLimits = std::to_array<std::string_view>({
    "limits.of_any_case",
    "limits.of_a_file",
    "limits.of_a_decimal",
    "limits.of_work",
    "limits.of_splits",
});

constexpr auto kLinear = std::to_array<std::string_view>({
    "linear.decision_is_proven",
});

constexpr auto kMethods = std::to_array<std::string_view>({
    "methods.not_contradicted",
    "methods.not_contradicted_anywhere",
    "methods.optimised",
    "methods.optimised_alike",
    "methods.no_state",
    "methods.same_in_any_environment",
    "methods.sensible_answers",
    "methods.budget",
    "methods.long_time_step",
    "methods.not_early",
    "methods.split",
    "methods.miss_what_is_far_apart",
    "methods.hit_where_points_meet",
    "methods.scale",
    "methods.scale_time",
    "methods.mirror",
});

constexpr auto kPluginLines = std::to_array<std::string_view>({
    "plugin.any_line",
    "plugin.achieves_no_looser_tolerance",
    "plugin.claims_are_limited",
});

constexpr auto kQueryCsv = std::to_array<std::string_view>({
    "csv.any_bytes",
});

constexpr auto kSubPatch = std::to_array<std::string_view>({
    "sub_patch.is_the_restriction",
    "paper.sub_patch_error",
    "cell.children_cover",
    "cell.trees_agree",
    "patch.convex_hull",
    "patch.partition_of_unity",
    "patch.blossom_symmetry",
    "patch.elevation",
});

constexpr auto kTdibmC = std::to_array<std::string_view>({
    "tdibm-c.no_false_negative",
    "tdibm-c.no_false_negative_underflow",
    "tdibm-c.no_false_negative_anywhere",
    "tdibm-c.no_false_negative_fine",
    "tdibm-c.no_false_negative_linear",
    "tdibm-c.linear_decided_exactly",
    "tdibm-c.doubles_decide_exactly",
    "tdibm-c.trace",
    "tdibm-c.normalised",
    "tdibm-c.sub_patches",
    "tdibm-c.error_bound",
    "tdibm-c.windows",
    "tdibm-c.contact_swapped",
    "tdibm-c.contact_reparametrised",
    "tdibm-c.contact_permuted",
    "tdibm-c.contact_mirrored",
    "tdibm-c.contact_translated",
    "tdibm-c.contact_drifting",
    "tdibm-c.contact_backwards",
    "tdibm-c.contact_elevated",
    "tdibm-c.contact_in_a_part",
});

constexpr auto kTdibmE = std::to_array<std::string_view>({
    "tdibm-e.no_false_negative",
    "tdibm-e.trace",
    "tdibm-e.contact_transformed",
});

constexpr auto kTdibmEEnvelope = std::to_array<std::string_view>({
    "tdibm-e.envelope",
    "tdibm-e.conservative_decisions",
    "tdibm-e.convex_chain",
    "tdibm-e.coefficient_error",
    "tdibm-e.eps_constr",
    "lines.sorting",
    "paper.axis_error",
    "paper.linear_bound",
    "paper.eps_coeff",
    "paper.eps_Phi",
    "paper.eps_phi",
    "paper.eps_arith",
    "paper.Delta_phi",
    "paper.Delta_Phi",
    "paper.theorem_4_1",
    "paper.eq_13_second",
    "paper.each_line_once",
});

constexpr auto kTdibmESeparation = std::to_array<std::string_view>({
    "tdibm-e.separation",
    "tdibm-e.ends",
    "tdibm-e.pulled_roots",
    "tdibm-e.safe_roots",
    "tdibm-e.safe_roots_of_sums",
    "paper.eps_Psi",
    "paper.eps_tau",
    "paper.overlap",
    "paper.one_interval",
    "paper.steps_are_exact",
    "paper.step_three",
    "tdibm.ends",
    "paper.eq_18",
    "paper.path_is_case_1",
    "paper.eq_7_terminates",
    "paper.eq_7_clamped",
    "paper.eq_8b_9b_omit",
});

constexpr auto kTdibmRational = std::to_array<std::string_view>({
    "tdibm-rational.no_false_negative",
    "tdibm-rational.no_false_negative_fine",
    "tdibm-rational.no_false_negative_linear",
    "tdibm-rational.trace",
    "tdibm-rational.error_bound",
});

constexpr std::string_view kRefutedBound = "refuted bound", kFalseNegative = "false negative",
                           kDisagreement = "disagreement", kRefutedClaim = "refuted claim";

/// In the first byte.
constexpr std::uint8_t kDrawn = 128;

struct Names {
  std::string_view target, find;
  std::span<const std::string_view> claims;
  bool reads_texts = false;
};

constexpr auto kTargets = std::to_array<Names>({
    {"any_bits", kRefutedClaim, kAnyBits},
    {"arithmetic", kRefutedBound, kArithmetic},
    {"case_reader", kRefutedClaim, kCaseReader, true},
    {"certificates", kRefutedClaim, kCertificates},
    {"generators", kRefutedClaim, kGenerators},
    {"judge", kRefutedClaim, kJudge},
    {"limits", kRefutedClaim, kLimits},
    {"linear", kDisagreement, kLinear},
    {"methods", kDisagreement, kMethods},
    {"plugin_lines", kRefutedClaim, kPluginLines, true},
    {"query_csv", kRefutedClaim, kQueryCsv, true},
    {"sub_patch", kRefutedBound, kSubPatch},
    {"tdibm_c", kFalseNegative, kTdibmC},
    {"tdibm_e", kFalseNegative, kTdibmE},
    {"tdibm_e_envelope", kRefutedBound, kTdibmEEnvelope},
    {"tdibm_e_separation", kRefutedBound, kTdibmESeparation},
    {"tdibm_rational", kFalseNegative, kTdibmRational},
});

}  // namespace

std::vector<std::string_view> fuzz_targets() {
  std::vector<std::string_view> names;
  names.reserve(kTargets.size());
  for (const Names& target : kTargets) names.push_back(target.target);
  return names;
}

Result<FuzzTarget> fuzz_target_named(std::string_view name) {
  const auto* const found = std::ranges::find(kTargets, name, &Names::target);
  if (found == kTargets.end()) {
    return input_error(
        "", fmt::format("no target \"{}\"; there are: {}", name, fmt::join(fuzz_targets(), ", ")));
  }
  FuzzTarget target{found->target, found->find, found->reads_texts, {}};
  for (const std::string_view claim : found->claims) {
    const Result<Property> property = property_named(claim);
    if (!property) return tl::unexpected(property.error());
    target.claims.push_back(*property);
  }
  return target;
}

Draw ClaimInput::choices() const {
  return seed ? draws_of(*seed) : Draw::from_bytes(bytes);
}

Draw draws_of(std::uint64_t seed) {
  return Draw::mostly_small(Random::keyed({seed, 0}));
}

std::optional<ClaimInput> claim_input(const FuzzTarget& target,
                                      std::span<const std::uint8_t> bytes) {
  if (target.reads_texts) return ClaimInput{target.claims[0], bytes, {}};
  if (bytes.empty()) return std::nullopt;
  const std::size_t claim = bytes[0] & ~kDrawn;
  ClaimInput input{target.claims[claim % target.claims.size()], bytes.subspan(1), {}};
  if ((bytes[0] & kDrawn) == 0) return input;
  std::uint64_t seed = 0;
  const std::size_t given = std::min(input.bytes.size(), sizeof seed);
  for (std::size_t i = 0; i < given; ++i) seed |= std::uint64_t{input.bytes[i]} << 8 * i;
  input.seed = seed;
  return input;
}

std::vector<std::uint8_t> drawn_input(Draw& random) {
  std::vector<std::uint8_t> input = {static_cast<std::uint8_t>(kDrawn | random.below(kDrawn))};
  for (std::size_t i = 0; i < sizeof(std::uint64_t); ++i) {
    input.push_back(static_cast<std::uint8_t>(random.below(256)));
  }
  return input;
}

std::optional<std::vector<std::uint8_t>> drawn_as_bytes(const FuzzTarget& target,
                                                        std::span<const std::uint8_t> input) {
  const auto drawn = claim_input(target, input);
  if (!drawn || !drawn->seed) return std::nullopt;
  Draw choices = drawn->choices();
  run(drawn->property, choices);
  std::vector<std::uint8_t> bytes = {static_cast<std::uint8_t>(input[0] & ~kDrawn)};
  bytes.insert(bytes.end(), choices.bytes().begin(), choices.bytes().end());
  return bytes;
}

}  // namespace ccdfuzz
