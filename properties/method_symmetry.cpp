#include "case/scale.hpp"
#include "generators/similar.hpp"
#include "properties/answers.hpp"
#include "properties/no_false_negative.hpp"
#include "properties/show.hpp"

namespace ccdfuzz {

namespace {

/// Whether the largest products of a method are doubles. The released program's axes are products
/// of up to six lengths, and Steps II and III multiply two heights: fourteen lengths.
bool keeps_products(const Query& query) {
  const double size = largest_coordinate(query);
  return 0x1p-64 < size && size < 0x1p64;
}

/// The query after a drawn change of coordinates; nothing if a number is not a double then.
using Symmetry = std::optional<Query>(const Query& query, Draw& d);

std::optional<Query> scaled(const Query& query, Draw& d) {
  return similar(query, {.space = d.integer(-60, 60)});
}
std::optional<Query> scaled_in_time(const Query& query, Draw& d) {
  return similar(query, {.time = d.integer(-60, 60)});
}
std::optional<Query> mirrored(const Query& query, Draw& d) {
  return on_other_axes(query, 0, d.integer(0, 2));
}
std::optional<Query> in_other_order(const Query& query, Draw&) {
  return swapped(query);
}

/// Checks that one of the methods answers a drawn contact, and the same after a change, alike.
/// Equal bit for bit are the verdict, and toi except for the unit of time.
std::function<void(Draw&)> answers_alike(const std::vector<std::string>& methods,
                                         Symmetry* symmetry) {
  return [=](Draw& d) {
    const std::string method = show(d, "method", d.pick(methods));
    const Query before = show(d, "before", supposed(draw_contact(d, kOrdinaryRange)).query);
    const Query after = show(d, "after", supposed(symmetry(before, d)));
    suppose(keeps_products(before) && keeps_products(after));
    const Answer first = answer_of(method, before, kQuickSearch);
    const Answer second = answer_of(method, after, kQuickSearch);
    suppose(first.verdict != Verdict::kUndecided && second.verdict != Verdict::kUndecided);
    const double unit = before.t_max > 0 ? after.t_max / before.t_max : 1;  // a power of two
    show(d, "toi", first.toi);
    show(d, "then", second.toi);
    CLAIM(first.verdict == second.verdict);
    CLAIM(!first.toi || *first.toi * unit == *second.toi);
  };
}

/// Each method in the form whose windows are exact, or have no margin in units of time.
std::vector<std::string> without_margins() {
  std::vector<std::string> specs = every_method_but();
  for (std::string& spec : specs) {
    const std::string exact = spec + "@exact-windows";
    if (make_method(exact)) spec = exact;
  }
  return specs;
}

/// These step to the crossing of an upper and a lower envelope, and try the lines of one of them
/// first. That matters where rounding decides; some also count the steps (Eq. 18). A mirror or a
/// swap exchanges the two, and now and then moves an answer: by thousands of ulps where the
/// crossing lines are almost parallel. methods.not_early holds that of tdibm-e to the time that its
/// boxes explain; the others may also miss.
const std::vector<std::string> kMirrorMatters = {"tdibm", "tdibm-h:1e-12", "tdibm-e",
                                                 "tdibm-e-literal"};
/// So does pulling envelopes apart, which is rounded.
const std::vector<std::string> kOrderMatters = {"tdibm", "tdibm-e", "tdibm-e-literal",
                                                "tdibm-h:1e-12", "tdibm-h:1e-12@absolute"};

}  // namespace

std::vector<Property> method_symmetry_claims() {
  return {
      {"methods.scale", "Scaling space by a power of two changes no answer", "Section 3",
       answers_alike(every_method_but(), scaled)},
      {"methods.scale_time", "Scaling time by a power of two scales toi", "Section 3",
       answers_alike(without_margins(), scaled_in_time)},
      {"methods.mirror", "A mirror changes no answer", "Section 3",
       answers_alike(every_method_but(kMirrorMatters), mirrored)},
      {"tdibm.mirror", "A mirror changes no answer of the paper's methods in doubles", "Section 3",
       answers_alike(kMirrorMatters, mirrored), kFails},
      {"tdibm.swap", "Swapping the patches changes no answer of the paper's methods in doubles",
       "Section 3", answers_alike(kOrderMatters, in_other_order), kFails},
  };
}

}  // namespace ccdfuzz
