#include <algorithm>
#include <cmath>

#include "files/case_json.hpp"
#include "generators/draw_patch.hpp"
#include "method/method.hpp"
#include "properties/answers.hpp"
#include "properties/draw_first_contact.hpp"
#include "properties/no_false_negative.hpp"
#include "properties/property.hpp"
#include "properties/show.hpp"
#include "properties/symmetry.hpp"

namespace ccdfuzz {

namespace {

void show_answer(Draw& d, std::string_view name, const Answer& answer) {
  show(d, name, answer.verdict);
  show(d, "pops", answer.pops);
  show(d, "toi", answer.toi);
}

/// A run that may take no more pops than n, against one that took P. For n = P the answer is the
/// same. For fewer it is undecided after n pops, with a time that is no later than that of the hit.
void check_budget(Draw& d) {
  constexpr std::array kSearching = {"tdibm-c", "tdibm-rational", "tdibm-e", "tdibm", "trad"};
  constexpr SearchOptions kWhole = {0x1p-4, 60, SearchOptions().max_bytes};
  const char* name = d.pick(kSearching);
  const Case drawn = supposed(draw_contact(d, {}));
  const auto method = *make_method(name);
  const Answer whole = method->answer(drawn.query, kWhole);
  SearchOptions part = kWhole;
  part.max_pops = d.choose(whole.pops);
  const Answer cut = method->answer(drawn.query, part);
  const bool is_whole = part.max_pops == whole.pops;
  show(d, "method", name);
  show_answer(d, "whole", whole);
  show(d, "budget", part.max_pops);
  show_answer(d, "cut", cut);
  show(d, "contact", drawn);
  CLAIM(cut.pops == part.max_pops);
  CLAIM(cut.verdict == (is_whole ? whole.verdict : Verdict::kUndecided));
  if (cut.verdict == Verdict::kMiss || whole.verdict != Verdict::kHit) return;
  CLAIM(cut.toi && *cut.toi <= *whole.toi);
}

/// Contacts within the first 2^-20 of the time step and less.
void check_long_time_step(Draw& d) {
  Case drawn = supposed(draw_contact(d, kOrdinaryRange));
  const int longer = static_cast<int>(d.integer(0, 30));
  drawn.query.t_max = std::ldexp(drawn.query.t_max, longer);
  const char* method = d.pick(std::array{"tdibm-c", "tdibm-rational"});
  claim_no_false_negative(method, drawn, kQuickSearch, d);
}

void check_not_early(Draw& d) {
  const FirstContact drawn = supposed(draw_first_contact(d));
  claim_not_early(d.pick(std::array{"tdibm-c", "tdibm-rational", "tdibm-e"}), drawn, d);
}

/// One of the patches is split: control points of parts are within those of the patch, and so are
/// the boxes of their cells.
void check_split(Draw& d) {
  const FirstContact drawn = supposed(draw_first_contact(d));
  const char* name = d.pick(std::array{"tdibm-c", "tdibm-rational"});
  const auto method = *make_method(name);
  const Answer whole = method->answer(drawn.query, kFineSearch);
  const std::size_t side = d.choose(1);
  const MovingPatch<double>& patch = drawn.query.patches[side];
  Answer least;
  for (int c = 0; c < patch.shape.child_count(); ++c) {
    Query of_part = drawn.query;
    of_part.patches[side] = supposed(part_over(patch, Cell().child(patch.shape, c)));
    const Answer answer = method->answer(of_part, kFineSearch);
    suppose(answer.verdict != Verdict::kUndecided);
    if (answer.verdict != Verdict::kHit) continue;
    if (least.verdict != Verdict::kHit || *answer.toi < *least.toi) least = answer;
  }
  suppose(whole.verdict != Verdict::kUndecided);
  show(d, "method", name);
  show_answer(d, "whole", whole);
  show_answer(d, "least", least);
  show(d, "of the parts of patch", side + 1);
  show(d, "contact at", drawn.t);
  show(d, "explained", drawn.early);
  show(d, "query", drawn.query);
  CLAIM(whole.verdict == Verdict::kHit);
  CLAIM(least.verdict == Verdict::kHit);
  CLAIM(*least.toi <= drawn.t);
  CLAIM(std::abs(*least.toi - *whole.toi) <= drawn.early);
}

/// A parallelogram, a triangle or a line by any degree: parts of it have the same axes.
MovingPatch<double> draw_affine_patch(Draw& choices) {
  const auto draw_vector = [&](int bits) {
    Vec3<double> v;
    const std::int64_t most = (std::int64_t{1} << bits) - 1;
    for (int k = 0; k < 3; ++k) v[k] = static_cast<double>(choices.integer(-most, most));
    return v;
  };
  MovingPatch<double> patch;
  patch.shape = draw_shape(choices, 2);
  const Vec3<double> corner = draw_vector(2), along_u = draw_vector(3), along_v = draw_vector(3);
  const Vec3<double> velocity = draw_vector(1);
  const Shape& shape = patch.shape;
  for (int i = 0; i <= shape.n; ++i) {
    const int columns = shape.kind == ShapeKind::kTriangle ? shape.n - i : shape.m;
    for (int j = 0; j <= columns; ++j) {
      patch.positions.push_back(corner + along_u * i + along_v * j);
      patch.velocities.push_back(velocity);
    }
  }
  return patch;
}

/// It keeps what it has of parts.
void check_optimised_alike(Draw& d) {
  const std::string name = d.pick(std::array{"tdibm", "tdibm-e", "tdibm-h:1e-12"});
  constexpr SearchOptions kWhole = {0x1p-5, 100, SearchOptions().max_bytes};
  Query query;
  for (MovingPatch<double>& patch : query.patches) patch = draw_affine_patch(d);
  if (d.coin()) {
    auto& [first, second] = query.patches;
    for (Vec3<double>& v : second.velocities) v = first.velocities[0];
  }
  const Answer fast = (*make_method(name))->answer(query, kWhole);
  const Answer plain = (*make_method(name + std::string(kUnoptimised)))->answer(query, kWhole);
  show(d, "method", name);
  show_answer(d, "fast", fast);
  show_answer(d, "plain", plain);
  show(d, "query", query);
  claim_same(fast, plain);
}

}  // namespace

std::vector<Property> searches_claims() {
  return {
      {"methods.budget",
       "With fewer pops than an answer takes, a method is undecided, at a time not after the hit",
       "src/ccd/search.hpp", check_budget},
      {"methods.long_time_step", "No contact early in a long time step is missed or reported late",
       "src/ccd/certified/tdibm_c.hpp, src/ccd/rational/DERIVATION.md", check_long_time_step},
      {"methods.not_early",
       "A hit is early by no more than the time in which boxes of its precision meet",
       "src/ccd/certified/tdibm_c.hpp", check_not_early},
      {"methods.split",
       "The answer over two patches is the least over the parts of either, as far as boxes tell",
       "src/ccd/certified/tdibm_c.hpp", check_split},
      {"methods.optimised_alike",
       "The optimised form of a method answers as the plain one where all parts are alike",
       "src/ccd/DERIVATION.md", check_optimised_alike},
  };
}

}  // namespace ccdfuzz
