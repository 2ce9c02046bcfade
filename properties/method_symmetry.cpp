#include "case/scale.hpp"
#include "properties/answers.hpp"
#include "properties/no_false_negative.hpp"
#include "properties/show.hpp"
#include "properties/symmetry.hpp"

namespace ccdfuzz {

namespace {

/// Whether the largest products of a method are doubles. The released program's axes are products
/// of up to six lengths, and Steps II and III multiply two heights: fourteen lengths.
bool keeps_products(const Query& query) {
  const double size = largest_coordinate(query);
  return 0x1p-64 < size && size < 0x1p64;
}

/// Checks that one of the methods answers a drawn contact, and the same after a change, alike.
/// Equal bit for bit are the verdict, and toi except for the unit of time.
template <std::size_t N>
std::function<void(Draw&)> answers_alike(const std::array<const char*, N>& methods,
                                         Symmetry symmetry) {
  return [=](Draw& d) {
    const char* method = show(d, "method", d.pick(methods));
    const Case before = show(d, "before", supposed(draw_contact(d, kOrdinaryRange)));
    const Case after = show(d, "after", supposed(transformed(before, symmetry, d)));
    suppose(keeps_products(before.query) && keeps_products(after.query));
    const Answer first = answer_of(method, before.query, kQuickSearch);
    const Answer second = answer_of(method, after.query, kQuickSearch);
    suppose(first.verdict != Verdict::kUndecided && second.verdict != Verdict::kUndecided);
    const double t_before = before.query.t_max, t_after = after.query.t_max;
    const double unit = t_before > 0 ? t_after / t_before : 1;  // a power of two
    show(d, "toi", first.toi);
    show(d, "then", second.toi);
    CLAIM(first.verdict == second.verdict);
    CLAIM(!first.toi || *first.toi * unit == *second.toi);
  };
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
/// These step to the crossing of an upper and a lower envelope, and try the lines of one of them
/// first. That matters where rounding decides; some also count the steps (Eq. 18). A mirror or a
/// swap exchanges the two, and now and then moves an answer: by thousands of ulps where the
/// crossing lines are almost parallel. methods.not_early holds that of tdibm-e to the time that its
/// boxes explain; the others may also miss.
constexpr std::array kMirrorMatters = {"tdibm", "tdibm-h:1e-12", "tdibm-e", "tdibm-e-literal"};
/// So does pulling envelopes apart, which is rounded.
constexpr std::array kOrderMatters = {"tdibm", "tdibm-e", "tdibm-e-literal", "tdibm-h:1e-12",
                                      "tdibm-h:1e-12@absolute"};

}  // namespace

std::vector<Property> method_symmetry_claims() {
  return {
      {"methods.scale", "Scaling space by a power of two changes no answer", "Section 3",
       answers_alike(kScaleFree, Symmetry::kScale)},
      {"methods.scale_time", "Scaling time by a power of two scales toi", "Section 3",
       answers_alike(kTimeScaleFree, Symmetry::kScaleTime)},
      {"methods.mirror", "A mirror changes no answer", "Section 3",
       answers_alike(kMirrorFree, Symmetry::kMirror)},
      {"tdibm.mirror", "A mirror changes no answer of the paper's methods in doubles", "Section 3",
       answers_alike(kMirrorMatters, Symmetry::kMirror), kFails},
      {"tdibm.swap", "Swapping the patches changes no answer of the paper's methods in doubles",
       "Section 3", answers_alike(kOrderMatters, Symmetry::kSwapPatches), kFails},
  };
}

}  // namespace ccdfuzz
