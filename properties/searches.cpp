#include "bezier/exact_patch.hpp"
#include "bezier/restrict.hpp"
#include "generators/draw_patch.hpp"
#include "method/method.hpp"
#include "properties/answers.hpp"
#include "properties/draw_weighted.hpp"
#include "properties/no_false_negative.hpp"
#include "properties/show.hpp"

namespace ccdfuzz {

namespace {

/// A run that may take no more pops than n, against one that took P. For n = P the answer is the
/// same. For fewer it is undecided after n pops, with a time that is no later than that of the hit.
/// The oracle's budget is that of each of its searches.
void check_budget(Draw& d) {
  constexpr SearchOptions kWhole = {0x1p-4, 60, SearchOptions().max_bytes};
  const std::string name = d.pick(every_method_but({"oracle"}));
  const Case drawn = supposed(draw_contact(d, {}));
  const Answer whole = asked(d, name, drawn.query, kWhole);
  SearchOptions part = kWhole;
  part.max_pops = d.choose(whole.pops);
  show(d, "budget", part.max_pops);
  const Answer cut = asked(d, name, drawn.query, part);
  const bool is_whole = part.max_pops == whole.pops;
  CLAIM(cut.pops == part.max_pops);
  CLAIM(cut.verdict == (is_whole ? whole.verdict : Verdict::kUndecided));
  if (cut.verdict == Verdict::kMiss || whole.verdict != Verdict::kHit) return;
  CLAIM(cut.toi && *cut.toi <= *whole.toi);
}

/// A child of a patch in exact arithmetic, if doubles hold it.
std::optional<MovingPatch<double>> child_of(const MovingPatch<double>& patch, int child) {
  const Cell cell = Cell().child(patch.shape, child);
  return to_doubles(
      restrict_to(exact_patch<Dyadic>(patch), exact_corners<Dyadic>(cell.corners(patch.shape))));
}

/// Also of rational patches, or of a part of one patch, whether it has the contact or not. Its
/// boxes are within those of the patch, and come no slower.
void check_not_early(Draw& d) {
  const std::string name = d.pick(every_method_but({}, &MethodInfo::claims_no_false_negative));
  if (d.choose(2) == 2) return claim_not_early(name, draw_weighted_first_contact(d), d);
  const FirstContact drawn = draw_first_contact(d);
  if (d.coin()) return claim_not_early(name, drawn, d);
  Query of_part = drawn.query;
  MovingPatch<double>& patch = of_part.patches[d.choose(1)];
  const auto last_child = static_cast<std::uint64_t>(patch.shape.child_count() - 1);
  patch = supposed(child_of(patch, static_cast<int>(d.choose(last_child))));
  const Answer answer = asked(d, name, of_part, kFineSearch);
  const double t = show(d, "contact at", drawn.truth.witness->t.get_d());
  show(d, "explained", drawn.early);
  CLAIM(answer.verdict != Verdict::kHit || t - *answer.toi <= drawn.early);
}

/// A parallelogram, a triangle or a line by any degree: parts of it have the same axes.
MovingPatch<double> draw_affine_patch(Draw& choices) {
  MovingPatch<double> patch;
  patch.shape = draw_shape(choices, 2);
  const Vec3<double> corner = draw_integers(choices, 3), along_u = draw_integers(choices, 7),
                     along_v = draw_integers(choices, 7);
  const Vec3<double> velocity = draw_integers(choices, 1);
  for_each_control(patch.shape, [&](int i, int j) {
    patch.positions.push_back(corner + along_u * i + along_v * j);
    patch.velocities.push_back(velocity);
  });
  return patch;
}

/// Patches whose parts are alike, some at one velocity.
Query draw_alike(Draw& d) {
  Query query;
  for (MovingPatch<double>& patch : query.patches) patch = draw_affine_patch(d);
  if (d.coin()) {
    auto& [first, second] = query.patches;
    for (Vec3<double>& v : second.velocities) v = first.velocities[0];
  }
  return query;
}

/// It keeps what it has of parts: mostly, these are alike.
void check_optimised(Draw& d) {
  constexpr SearchOptions kWhole = {0x1p-5, 100, SearchOptions().max_bytes};
  std::vector<std::string> paper = every_method_but();
  std::erase_if(paper, [](const auto& spec) { return !make_method(spec + kUnoptimised); });
  const std::string name = draw_spec(d, paper);
  suppose(make_method(name + kUnoptimised).has_value());
  const Query query =
      d.choose(7) != 0 ? draw_alike(d) : supposed(draw_contact(d, {-1000, 900, 3})).query;
  const Answer fast = asked(d, name, query, kWhole);
  claim_same(fast, asked(d, name + kUnoptimised, query, kWhole));
}

}  // namespace

std::vector<Property> searches_claims() {
  return {
      {"methods.budget",
       "With fewer pops than an answer takes, a method is undecided, at a time not after the hit",
       "src/ccd/search.hpp", check_budget},
      {"methods.not_early",
       "A hit on patches, also rational ones, or a part of one is early by no more than the time "
       "in which boxes of its precision meet",
       "src/ccd/certified/tdibm_c.hpp", check_not_early},
      {"methods.optimised",
       "The optimised form of a method of the paper answers as the plain one, also where all parts "
       "are alike",
       "src/ccd/DERIVATION.md", check_optimised},
  };
}

}  // namespace ccdfuzz
