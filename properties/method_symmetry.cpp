#include "properties/method_symmetry.hpp"

#include <fmt/format.h>

#include "case/case_json.hpp"
#include "certify/checker/check_truth.hpp"
#include "method/method.hpp"
#include "properties/no_false_negative.hpp"
#include "properties/symmetry.hpp"

namespace ccdfuzz {

namespace {

/// A drawn contact, and the same after a change of the given kind.
struct DrawnChange {
  Case before, after;
};

Result<DrawnChange> draw_change(Draw& choices, Symmetry symmetry) {
  const Result<Case> before = draw_contact(choices, {});
  if (!before) return tl::unexpected(before.error());
  auto after = transformed(*before, symmetry, choices);
  if (!after) return input_error("", "a number is not a double");
  return DrawnChange{*before, *std::move(after)};
}

/// The contact is still one, and the method neither misses it nor is late.
Check contact_survives(const char* method, Symmetry symmetry, Draw& choices) {
  const Result<DrawnChange> drawn = draw_change(choices, symmetry);
  if (!drawn) return Check::discarded(drawn.error().message());
  if (const auto checked = check_truth(drawn->after); !checked) {
    return Check::fails("it is no contact: " + checked.error().message() + "\n" +
                        to_json(drawn->before));
  }
  return no_false_negative(method, drawn->after, kQuickSearch);
}

template <Symmetry symmetry>
Check check_certified(Draw& choices) {
  return contact_survives("tdibm-c", symmetry, choices);
}

Check check_error_bound(Draw& choices) {
  const Symmetry symmetry = choices.pick(kSymmetries);
  return contact_survives("tdibm-e", symmetry, choices);
}

/// The method answers both alike, bit for bit: verdict, and toi but for the unit of time.
template <std::size_t N>
Check same_answer(const std::array<const char*, N>& methods, Symmetry symmetry, Draw& choices) {
  const char* method = choices.pick(methods);
  const Result<DrawnChange> drawn = draw_change(choices, symmetry);
  if (!drawn) return Check::discarded(drawn.error().message());
  const auto answer = [&](const Query& query) {
    return (*make_method(method))->answer(query, kQuickSearch);
  };
  const Answer before = answer(drawn->before.query), after = answer(drawn->after.query);
  const bool gave_up =
      before.verdict == Verdict::kUndecided || after.verdict == Verdict::kUndecided;
  if (gave_up) return Check::discarded("a budget ran out");
  const double t_before = drawn->before.query.t_max, t_after = drawn->after.query.t_max;
  const double unit = t_before > 0 ? t_after / t_before : 1;  // a power of two
  const bool same =
      before.verdict == after.verdict && (!before.toi || *before.toi * unit == *after.toi);
  if (same) return Check::holds();
  const auto text = [](const Answer& a) { return a.toi ? to_hex(*a.toi) : std::string("none"); };
  return Check::fails(fmt::format("{} answers {}, then {}\n{}\n{}", method, text(before),
                                  text(after), to_json(drawn->before), to_json(drawn->after)));
}

/// Those whose arithmetic is the same at any power of two.
constexpr std::array kScaleFree = {"tdibm",         "tdibm-e",        "tdibm-e-literal",
                                   "tdibm-h:1e-12", "tdibm-rational", "tdibm-c",
                                   "trad",          "trad:aabb"};
/// Those of them whose windows are exact, or have no margin in units of time.
constexpr std::array kTimeScaleFree = {"tdibm@exact-windows",
                                       "tdibm-e",
                                       "tdibm-e-literal",
                                       "tdibm-h:1e-12@exact-windows",
                                       "tdibm-rational",
                                       "tdibm-c",
                                       "trad",
                                       "trad:aabb"};
/// Those whose arithmetic is the same in any mirror.
constexpr std::array kMirrorFree = {"tdibm-rational", "tdibm-c", "trad", "trad:aabb"};
/// These find where an upper and a lower envelope cross by steps that try the lines of one of them
/// first, which matters where rounding decides; some also count the steps (Eq. 18). What exchanges
/// the two, a mirror or a swap, moves an answer now and then: by thousands of ulps where the
/// crossing lines are almost parallel. methods.not_early holds that of tdibm-e to the time that its
/// boxes explain; the others may also miss.
constexpr std::array kMirrorMatters = {"tdibm", "tdibm-h:1e-12", "tdibm-e", "tdibm-e-literal"};
/// So does pulling envelopes apart, which is rounded.
constexpr std::array kOrderMatters = {"tdibm", "tdibm-e", "tdibm-e-literal", "tdibm-h:1e-12",
                                      "tdibm-h:1e-12@absolute"};

}  // namespace

std::vector<Property> method_symmetry_properties() {
  constexpr auto kHolds = Expectation::kHolds;
  constexpr const char* kDerivation = "src/ccd/certified/DERIVATION.md";
  return {
      {"tdibm-c.contact_swapped", "No contact is lost when the patches change places", kDerivation,
       kHolds, check_certified<Symmetry::kSwapPatches>},
      {"tdibm-c.contact_reparametrised",
       "No contact is lost when parameters are reversed or rotated", kDerivation, kHolds,
       check_certified<Symmetry::kReverseParameters>},
      {"tdibm-c.contact_permuted", "No contact is lost when the axes of space change places",
       kDerivation, kHolds, check_certified<Symmetry::kPermuteAxes>},
      {"tdibm-c.contact_mirrored", "No contact is lost in a mirror", kDerivation, kHolds,
       check_certified<Symmetry::kMirror>},
      {"tdibm-c.contact_translated", "No contact is lost far from the origin", kDerivation, kHolds,
       check_certified<Symmetry::kTranslate>},
      {"tdibm-c.contact_drifting", "No contact is lost under a common velocity", kDerivation,
       kHolds, check_certified<Symmetry::kCommonVelocity>},
      {"tdibm-c.contact_backwards", "No contact is lost when time runs backwards", kDerivation,
       kHolds, check_certified<Symmetry::kReverseTime>},
      {"tdibm-c.contact_elevated", "No contact is lost when a patch has higher degrees",
       kDerivation, kHolds, check_certified<Symmetry::kElevate>},
      {"tdibm-c.contact_in_a_part", "No contact is lost when a patch is cut down to a part with it",
       kDerivation, kHolds, check_certified<Symmetry::kPart>},
      {"tdibm-e.contact_transformed",
       "No contact is lost in any of these ways, where nothing underflows", "Section 4.6", kHolds,
       check_error_bound},
      {"methods.scale", "Scaling space by a power of two changes no answer", "Section 3", kHolds,
       [](Draw& c) { return same_answer(kScaleFree, Symmetry::kScale, c); }},
      {"methods.scale_time", "Scaling time by a power of two scales toi", "Section 3", kHolds,
       [](Draw& c) { return same_answer(kTimeScaleFree, Symmetry::kScaleTime, c); }},
      {"methods.mirror", "A mirror changes no answer", "Section 3", kHolds,
       [](Draw& c) { return same_answer(kMirrorFree, Symmetry::kMirror, c); }},
      {"tdibm.mirror", "A mirror changes no answer of the paper's methods in doubles", "Section 3",
       Expectation::kFails,
       [](Draw& c) { return same_answer(kMirrorMatters, Symmetry::kMirror, c); }},
      {"tdibm.swap", "Swapping the patches changes no answer of the paper's methods in doubles",
       "Section 3", Expectation::kFails,
       [](Draw& c) { return same_answer(kOrderMatters, Symmetry::kSwapPatches, c); }},
  };
}

}  // namespace ccdfuzz
