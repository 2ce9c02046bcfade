#include "properties/registry.hpp"

#include <fmt/format.h>

#include "properties/any_bits.hpp"
#include "properties/any_environment.hpp"
#include "properties/arithmetic.hpp"
#include "properties/case_claims.hpp"
#include "properties/case_file.hpp"
#include "properties/certificates.hpp"
#include "properties/certified_bounds.hpp"
#include "properties/coefficients.hpp"
#include "properties/dyadic_round_trip.hpp"
#include "properties/envelope.hpp"
#include "properties/filter_bound.hpp"
#include "properties/generator_steps.hpp"
#include "properties/geometry.hpp"
#include "properties/intersection.hpp"
#include "properties/judge_claims.hpp"
#include "properties/limits.hpp"
#include "properties/linear_certificates.hpp"
#include "properties/linear_queries.hpp"
#include "properties/method_answers.hpp"
#include "properties/method_symmetry.hpp"
#include "properties/miss_trees.hpp"
#include "properties/no_false_negative.hpp"
#include "properties/omission.hpp"
#include "properties/outside_data.hpp"
#include "properties/pair_windows.hpp"
#include "properties/polynomials.hpp"
#include "properties/predicates.hpp"
#include "properties/rounding.hpp"
#include "properties/search_claims.hpp"
#include "properties/shifts.hpp"
#include "properties/spoilt_certificates.hpp"
#include "properties/step_three.hpp"
#include "properties/sub_patch.hpp"
#include "properties/sweep.hpp"
#include "properties/traced.hpp"

namespace ccdfuzz {

namespace {

/// All products of two coordinates and then some stay normal.
constexpr ContactRange kOrdinary;
/// The products of two coordinates are subnormal or 0.
constexpr ContactRange kTiny{-545, -530};
/// Nothing that is drawn under- or overflows a double; products do both. Degrees up to 5.
constexpr ContactRange kAnywhere{-1000, 900, 5};
/// What users ask with, but for a budget that static and grazing contacts run out of.
constexpr SearchOptions kFullSearch = {1e-4, 2000, SearchOptions().max_bytes};

std::vector<Property> basic_properties() {
  constexpr auto kHolds = Expectation::kHolds;
  return {
      {"dyadic.round_trip",
       "A double goes to exact numbers and back without loss, and both exact number types agree on "
       "every sum, difference, product and order",
       "Section 5.4", kHolds, check_dyadic_round_trip},
      {"sub_patch.is_the_restriction", "The sub-patch over a cell equals the patch there, exactly",
       "Appendix A (b)", kHolds, check_sub_patch_is_the_restriction},
      {"case_file.round_trip", "A case that is written and read is the same case",
       "the case format", kHolds, check_case_round_trip},
      {"case_file.any_bytes",
       "The reader refuses any text with a reason, or reads a case that it writes and reads again",
       "the case format", kHolds, check_reader_on_bytes},
      {"case_file.mutants", "The same of texts that are almost case files", "the case format",
       kHolds, check_reader_on_mutants},
  };
}

std::vector<Property> no_false_negative_properties() {
  constexpr auto kHolds = Expectation::kHolds, kFails = Expectation::kFails;
  return {
      {"tdibm.no_false_negative", "No proven contact is missed, and none reported late",
       "Section 3, in double arithmetic", kFails,
       [](Draw& c) { return check_no_false_negative("tdibm", kOrdinary, c); }},
      {"tdibm-e.no_false_negative",
       "No proven contact is missed, and none reported late, where nothing underflows",
       "Section 4.6", kHolds,
       [](Draw& c) { return check_no_false_negative("tdibm-e", kOrdinary, c); }},
      {"tdibm-e.no_false_negative_underflow",
       "No proven contact is missed, and none reported late, for coordinates about 2^-535",
       "Section 4.6, which does not exclude underflow", kFails,
       [](Draw& c) { return check_no_false_negative("tdibm-e", kTiny, c); }},
      {"tdibm-e-literal.no_false_negative",
       "No proven contact is missed, and none reported late, where nothing underflows",
       "Section 4.6, with eps_Phi's sign as printed", kFails,
       [](Draw& c) { return check_no_false_negative("tdibm-e-literal", kOrdinary, c); }},
      {"tdibm-rational.no_false_negative", "No proven contact is missed, and none reported late",
       "exact arithmetic", kHolds,
       [](Draw& c) { return check_no_false_negative("tdibm-rational", kOrdinary, c); }},
      {"tdibm-c.no_false_negative", "No proven contact is missed, and none reported late",
       "src/ccd/certified/DERIVATION.md", kHolds,
       [](Draw& c) { return check_no_false_negative("tdibm-c", kOrdinary, c); }},
      {"tdibm-c.no_false_negative_underflow",
       "No proven contact is missed, and none reported late, for coordinates about 2^-535",
       "src/ccd/certified/DERIVATION.md", kHolds,
       [](Draw& c) { return check_no_false_negative("tdibm-c", kTiny, c); }},
      {"tdibm-c.no_false_negative_anywhere",
       "No proven contact is missed, and none reported late, for coordinates from 2^-1000 to "
       "2^900, "
       "degrees up to 5 and the default precision",
       "src/ccd/certified/DERIVATION.md", kHolds,
       [](Draw& c) { return check_no_false_negative("tdibm-c", kAnywhere, c, kFullSearch); }},
  };
}

}  // namespace

const std::vector<Property>& properties() {
  static const std::vector<Property> all = [] {
    std::vector<Property> list;
    for (const auto& family : {basic_properties,
                               envelope_properties,
                               no_false_negative_properties,
                               rounding_properties,
                               coefficient_properties,
                               predicate_properties,
                               omission_properties,
                               shift_properties,
                               intersection_properties,
                               step_three_properties,
                               sweep_properties,
                               geometry_properties,
                               linear_properties,
                               arithmetic_properties,
                               any_environment_properties,
                               generator_properties,
                               method_answer_properties,
                               any_bits_properties,
                               judge_properties,
                               method_symmetry_properties,
                               traced_properties,
                               search_properties,
                               certified_bound_properties,
                               pair_window_properties,
                               filter_bound_properties,
                               certificate_properties,
                               case_claim_properties,
                               polynomial_properties,
                               linear_certificate_properties,
                               miss_tree_properties,
                               spoilt_certificate_properties,
                               outside_data_properties,
                               limit_properties}) {
      for (const Property& property : family()) list.push_back(property);
    }
    return list;
  }();
  return all;
}

Result<Property> property_named(std::string_view name, const std::vector<Property>& among) {
  // Of a name that is almost right the few to choose from; of another it would be no help.
  constexpr int kMost = 8;
  const auto subject_of = [](std::string_view text) { return text.substr(0, text.find('.')); };
  std::string alike;
  int count = 0;
  for (const Property& p : among) {
    if (p.name == name) return p;
    const bool is_part = !name.empty() && p.name.find(name) != std::string_view::npos;
    if (!is_part && subject_of(p.name) != subject_of(name)) continue;
    alike += fmt::format("{}{}", alike.empty() ? "" : ", ", p.name);
    ++count;
  }
  const bool is_help = 0 < count && count <= kMost;
  return input_error("", fmt::format("no property \"{}\"; {}{}", name,
                                     is_help ? "there are: " : "the list is: ccdfuzz properties",
                                     is_help ? alike : ""));
}

}  // namespace ccdfuzz
