#include <cmath>

#include "bezier/exact_patch.hpp"
#include "bezier/orientation.hpp"
#include "bezier/trim.hpp"
#include "bezier/trim_region.hpp"
#include "ccd/witness_trace/trace.hpp"
#include "certify/checker/check_box.hpp"
#include "certify/checker/check_linear.hpp"
#include "certify/checker/check_tree.hpp"
#include "certify/checker/check_trim.hpp"
#include "certify/checker/check_truth.hpp"
#include "certify/checker/check_witness.hpp"
#include "certify/checker/miss_tree.hpp"
#include "certify/oracle/build_tree.hpp"
#include "certify/oracle/find_contact.hpp"
#include "certify/oracle/oracle.hpp"
#include "files/case_json.hpp"
#include "fuzz/mutator/case_bytes.hpp"
#include "fuzz/mutator/trim_moves.hpp"
#include "generators/draw_patch.hpp"
#include "generators/draw_trim.hpp"
#include "method/method.hpp"
#include "properties/draw_first_contact.hpp"
#include "properties/draw_trimmed.hpp"
#include "properties/no_false_negative.hpp"
#include "properties/show.hpp"

namespace ccdfuzz {

namespace {

Shape draw_surface(Draw& d) {
  return d.coin() ? Shape::triangle(1) : Shape::tensor(1, 1);
}

Uv<double> draw_place(Draw& d, const Shape& shape) {
  const Uv<Dyadic> uv = draw_uv(d, shape, 4);
  return {*uv[0].to_double_exactly(), *uv[1].to_double_exactly()};
}

Uv<Rational> exact_place(const Uv<double>& uv) {
  return {exact(uv[0]), exact(uv[1])};
}

/// Points that are nearly on a line, or anywhere, down to subnormal coordinates.
void check_trim_orientation(Draw& d) {
  std::array<Uv<double>, 3> p;
  const bool is_small = d.choose(3) == 3;
  for (Uv<double>& at : p) {
    for (double& x : at) {
      x = std::abs(*d.dyadic(53, -53).to_double_exactly());
      if (is_small) x = std::ldexp(x, -static_cast<int>(d.choose(1100)));
    }
  }
  if (d.coin()) {
    const double share = std::ldexp(static_cast<double>(d.choose(8)), -3);
    for (const std::size_t k : {std::size_t{0}, std::size_t{1}}) {
      p[2][k] = d.nudged(p[0][k] + share * (p[1][k] - p[0][k]), 1);
    }
  }
  const auto way = [&](std::size_t to, std::size_t k) {
    return Rational(exact(p[to][k]) - exact(p[0][k]));
  };
  const Rational area = way(1, 0) * way(2, 1) - way(1, 1) * way(2, 0);
  show(d, "points", p);
  CLAIM(orientation(p[0], p[1], p[2]) == sgn(area));
}

Cell draw_cell(Draw& d, const Shape& shape) {
  Cell cell;
  for (auto levels = d.choose(6); levels > 0; --levels) {
    cell = cell.child(
        shape, static_cast<int>(d.choose(static_cast<std::uint64_t>(shape.child_count() - 1))));
  }
  return cell;
}

/// A trim means the same to generator, checker, methods, files and fuzzers.
void check_trim_meaning(Draw& d) {
  const Case known = draw_trimmed(d);
  show(d, "contact", known);
  const bool is_inside = is_in_regions(known);
  const bool is_accepted = check_truth(known).has_value();
  CLAIM(is_accepted == is_inside);
  const auto q = supposed(contact_of(known));
  CLAIM(is_in_trims(q) == is_inside);
  const auto read = parse_case(to_json(known, JsonLayout::kOneLine), "drawn");
  CLAIM(read && read->query == known.query);
  const auto bytes = to_bytes(q);
  const auto of_bytes = bytes ? query_of(*bytes) : std::nullopt;
  CLAIM(!bytes || (of_bytes && *of_bytes == known.query));
  CLAIM(!bytes || contact_of_bytes(*bytes, QueryRange::kAll).has_value() == is_inside);
  CLAIM(!bytes || !contact_of_bytes(*bytes));
  const TakenQuery taken(known.query, {.ends = true, .separation = true, .weights = true});
  CLAIM(taken.query() == nullptr);
}

/// What spoils loops is refused, naming the loop; what a draw gives is not.
void check_trim_valid(Draw& d) {
  Query query = draw_any_query(d);
  MovingPatch<double>& patch = query.patches[d.choose(1)];
  suppose(patch.shape.parameter_count() == 2);
  patch.trim = draw_trim(d, patch.shape, draw_place(d, patch.shape));
  CLAIM(is_valid(query));
  auto& loop = patch.trim[d.below(patch.trim.size())];
  const std::size_t i = d.below(loop.size()), next = (i + 1) % loop.size();
  const Uv<double> a = loop[i], b = loop[next];
  switch (d.choose(5)) {
    case 0:
      loop.resize(2);
      break;
    case 1:
      loop[i][d.choose(1)] = d.pick(std::array{-0x1p-1074, 1 + 0x1p-52, std::nan(""), HUGE_VAL});
      break;
    case 2:  // there and back again
      loop.insert(loop.begin() + static_cast<std::ptrdiff_t>(i) + 1, {b, a});
      break;
    case 3:
      loop = {a, b, a, b};
      break;
    case 4:
      loop.insert(loop.begin() + static_cast<std::ptrdiff_t>(i), a);
      break;
    default:
      patch.shape = Shape::curve(1);
      patch.positions.resize(2);
      patch.velocities.resize(2);
      patch.weights.clear();
      patch.ends.clear();
  }
  show(d, "query", query);
  CLAIM(!is_valid(query));
  const auto refused = validate(query, "");
  CLAIM(!refused && refused.error().message().find(".trim") != std::string::npos);
}

/// Two codes that share nothing place each cell alike. A cell outside has no point of the region. A
/// cell inside has no other.
void check_trim_cells(Draw& d) {
  MovingPatch<double> patch{draw_surface(d), {}, {}};
  const Uv<double> p = draw_place(d, patch.shape);
  patch.trim = draw_trim(d, patch.shape, p);
  const Cell cell = draw_cell(d, patch.shape);
  TrimRegion domain;
  domain.assign(patch);
  const TrimRegion::Cover cover = domain.cover(cell);
  show(d, "shape", patch.shape);
  show(d, "trim", patch.trim);
  show(d, "cell", cell);
  show(d, "cover", static_cast<int>(cover));
  const auto corners = cell.corners(patch.shape);
  std::vector<Uv<Rational>> polygon;
  if (patch.shape.kind == ShapeKind::kTriangle) {
    for (const Uv<double>& c : corners) polygon.push_back(exact_place(c));
  } else {
    const auto [lo, hi] = std::array{exact_place(corners[0]), exact_place(corners[1])};
    polygon = {lo, {hi[0], lo[1]}, hi, {lo[0], hi[1]}};
  }
  Work work(kMostWork);
  const Region region = region_of(patch.trim, polygon, work);
  CLAIM((cover == TrimRegion::Cover::kInside) == (region == Region::kInside));
  CLAIM((cover == TrimRegion::Cover::kOutside) == (region == Region::kOutside));
  const auto claim_point = [&](const Uv<Rational>& at) {
    const bool is_in = is_in_region(patch.trim, at);
    CLAIM(!(is_in && cover == TrimRegion::Cover::kOutside));
    CLAIM(!(!is_in && cover == TrimRegion::Cover::kInside));
  };
  Uv<Rational> mean = {0, 0};
  for (const Uv<Rational>& at : polygon) {
    claim_point(at);
    for (const std::size_t k : {std::size_t{0}, std::size_t{1}}) {
      mean[k] += at[k] / static_cast<long>(polygon.size());
    }
  }
  claim_point(mean);
  if (contains(cell, patch.shape, exact_place(p))) claim_point(exact_place(p));
  for (const auto& loop : patch.trim) {
    for (const Uv<double>& vertex : loop) {
      // A vertex in the closed cell is of the region, so the cell is not outside.
      CLAIM(!contains(cell, patch.shape, exact_place(vertex)) ||
            cover == TrimRegion::Cover::kCrossed);
      CLAIM(domain.contains(vertex));
    }
  }
  CLAIM(domain.contains(p) == is_in_region(patch.trim, exact_place(p)));
}

/// A trim of all of the domain is none, to each method that has no linear decision.
void check_trim_whole(Draw& d) {
  const Case plain = supposed(draw_contact(d, {-2, 2, 3}));
  Query trimmed = plain.query;
  for (MovingPatch<double>& patch : trimmed.patches) {
    if (patch.shape.parameter_count() != 2) continue;
    patch.trim = {loop_about(patch.shape, {0, 0}, 0)};
  }
  suppose(is_trimmed(trimmed));
  show(d, "query", trimmed);
  for (const std::string method : {"tdibm-rational", "tdibm", "tdibm-e", "trad"}) {
    const auto asked = make_method(method).value();
    const Answer a = asked->answer(trimmed, kQuickSearch);
    const Answer b = asked->answer(plain.query, kQuickSearch);
    CLAIM(a.verdict == b.verdict && a.toi == b.toi && a.uv == b.uv && a.pops == b.pops);
  }
}

/// Each method drops a pair of cells that holds a contact of the region only if it does so of the
/// whole patches.
void check_trim_traces(Draw& d) {
  const Case known = draw_trimmed_contact(d);
  Query whole = known.query;
  for (MovingPatch<double>& patch : whole.patches) patch.trim.clear();
  show(d, "contact", known);
  for (const std::string method : {"tdibm", "tdibm-e", "trad", "tdibm-rational", "tdibm-c"}) {
    // Its trace of whole linear patches is that of the linear decision.
    if (method == "tdibm-c" && is_linear_query(whole)) continue;
    const auto tracer = make_tracer(method).value();
    const TraceOptions options{.precision = 0x1p-8, .all = true};
    const Witness& witness = *known.truth.witness;
    const Trace& trimmed = tracer->trace(known.query, witness, options);
    const auto seen = std::array{trimmed.pairs, trimmed.lost_pairs};
    const Trace& of_whole = tracer->trace(whole, witness, options);
    CLAIM(seen == std::array{of_whole.pairs, of_whole.lost_pairs});
  }
}

/// The cells of a hit are not outside: within their width of its parameters is a point of the
/// region.
void check_trim_hits(Draw& d) {
  const Case known = draw_trimmed(d);
  show(d, "query", known.query);
  for (const std::string method : {"tdibm-c", "tdibm-rational", "tdibm"}) {
    const Answer answer = make_method(method).value()->answer(known.query, kQuickSearch);
    if (answer.verdict != Verdict::kHit) continue;
    show(d, "method", method);
    show(d, "uv", answer.uv);
    for (std::size_t s = 0; s < 2; ++s) {
      const Uv<Rational> at = exact_place(answer.uv[s]);
      const Rational width = exact(kQuickSearch.precision);
      const std::vector<Uv<Rational>> square = {{at[0] - width, at[1] - width},
                                                {at[0] + width, at[1] - width},
                                                {at[0] + width, at[1] + width},
                                                {at[0] - width, at[1] + width}};
      Work work(kMostWork);
      CLAIM(region_of(known.query.patches[s].trim, square, work) != Region::kOutside);
    }
  }
}

/// The checker accepts what the oracle says, or this throws; where the contact counts, it never
/// says that there is none.
void check_trim_decision(Draw& d) {
  const Case known = draw_trimmed(d);
  show(d, "query", known.query);
  const OracleOptions little{.max_pops = 300, .max_tree_nodes = 1000};
  const Decision decision = decide(known.query, little);
  CLAIM(!is_in_regions(known) || decision.truth.collides != false);
}

/// A first contact is in a hole, at t_max, and nowhere else. The whole patches touch, and the
/// trimmed ones are proven not to. That proof is refused for the whole ones.
void check_trim_hole(Draw& d) {
  const FirstContact drawn = supposed(draw_first_contact(d));
  Query whole = drawn.query;
  whole.t_max = drawn.t;
  Query trimmed = whole;
  const std::size_t side = d.choose(1);
  MovingPatch<double>& patch = trimmed.patches[side];
  suppose(patch.shape.parameter_count() == 2);
  const Uv<Rational>& at = drawn.witness.uv[side];
  const int halvings = 1 + static_cast<int>(d.choose(2));
  patch.trim = {loop_about(patch.shape, {0, 0}, 0),
                loop_about(patch.shape, {at[0].get_d(), at[1].get_d()}, halvings)};
  suppose(is_valid(trimmed) && !is_in_region(patch.trim, at));
  show(d, "query", trimmed);
  const bool is_of_whole = check_witness(whole, drawn.witness).has_value();
  const bool is_of_trimmed = check_witness(trimmed, drawn.witness).has_value();
  CLAIM(is_of_whole && !is_of_trimmed);
  constexpr std::uint64_t kNodes = 4000;
  const auto tree = build_miss_tree(trimmed, exact(whole.t_max), kNodes);
  suppose(tree.has_value());
  const bool is_proven = check_tree(trimmed, exact(whole.t_max), *tree).has_value();
  const bool is_proven_of_whole = check_tree(whole, exact(whole.t_max), *tree).has_value();
  CLAIM(is_proven && !is_proven_of_whole);
  Query filled = trimmed;
  filled.patches[side].trim.pop_back();
  const bool is_proven_of_filled = check_tree(filled, exact(whole.t_max), *tree).has_value();
  CLAIM(!is_proven_of_filled);
}

/// A leaf "outside" is refused where a cell of the contact counts, whatever the side.
void check_trim_outside_leaf(Draw& d) {
  const Case known = draw_trimmed_contact(d);
  TreeBits bits;
  const int side = static_cast<int>(d.choose(1));
  bits.outside(side);
  show(d, "contact", known);
  CLAIM(!check_tree(known.query, Rational(0), bits.bytes()));
}

/// A contact box of whole patches, one of which is a surface: its side and its radius there.
struct DrawnBox {
  Query query;
  ContactBox box;
  std::size_t side = 0;
  std::array<double, 2> radius{};  ///< the one of that side's parameters
};

DrawnBox draw_box(Draw& d) {
  DrawnBox out;
  Witness witness;
  if (d.coin()) {
    const FirstContact drawn = supposed(draw_first_contact(d));
    out.query = drawn.query, witness = drawn.witness;
  } else {
    const Case known = supposed(draw_contact(d, {-2, 2, 2}));
    out.query = known.query, witness = *known.truth.witness;
  }
  Suspicion near{{}, round_down(witness.t), 0x1p-20};
  for (std::size_t s = 0; s < 2; ++s) {
    near.uv[s] = {witness.uv[s][0].get_d(), witness.uv[s][1].get_d()};
  }
  out.box = supposed(find_contact_box(out.query, near));
  out.side = d.choose(1);
  suppose(out.query.patches[out.side].shape.parameter_count() == 2);
  for (std::size_t i = 0; i < 3; ++i) {
    const auto place = static_cast<std::size_t>(out.box.varied[i]);
    if (place / 2 == out.side) out.radius[place % 2] = out.box.radius[i];
  }
  return out;
}

/// A box that is accepted has its corners in the region, and no vertex of a loop inside.
void check_trim_boxes(Draw& d) {
  auto [query, box, side, radius] = draw_box(d);
  MovingPatch<double>& patch = query.patches[side];
  const std::array<double, 2> centre = {box.centre[2 * side], box.centre[2 * side + 1]};
  const auto z = static_cast<std::size_t>(box.dependent[side]);
  const auto place = [&](const Rational& a, const Rational& b) -> Uv<Rational> {
    std::array<Rational, 3> barycentrics;
    barycentrics[z] = 1 - a - b;
    barycentrics[(z + 1) % 3] = a;
    barycentrics[(z + 2) % 3] = b;
    return {barycentrics[1], barycentrics[2]};
  };
  const Uv<Rational> at = place(exact(centre[0]), exact(centre[1]));
  // Loops as large as the box, too.
  patch.trim = {
      loop_about(patch.shape, {0, 0}, 0),
      loop_about(patch.shape, {at[0].get_d(), at[1].get_d()}, static_cast<int>(d.choose(48)))};
  if (d.coin()) patch.trim.erase(patch.trim.begin());
  if (d.coin()) {
    for (auto& vertex : patch.trim.back())
      vertex[0] += static_cast<double>(d.choose(2)) * radius[0];
  }
  suppose(is_valid(query));
  show(d, "query", query);
  show(d, "radius", radius);
  show(d, "centre", centre);
  if (!check_box(query, box)) return;
  for (const int i : {-1, 0, 1}) {
    for (const int j : {-1, 0, 1}) {
      CLAIM(is_in_region(patch.trim, place(exact(centre[0]) + i * exact(radius[0]),
                                           exact(centre[1]) + j * exact(radius[1]))));
    }
  }
  if (radius[0] == 0 || radius[1] == 0) return;
  for (const auto& loop : patch.trim) {
    for (const Uv<double>& vertex : loop) {
      const Uv<Rational> uv = exact_place(vertex);
      const std::array<Rational, 3> barycentrics = {Rational(1 - uv[0] - uv[1]), uv[0], uv[1]};
      const bool is_beside = abs(barycentrics[(z + 1) % 3] - exact(centre[0])) > exact(radius[0]) ||
                             abs(barycentrics[(z + 2) % 3] - exact(centre[1])) > exact(radius[1]);
      CLAIM(is_beside);
    }
  }
}

/// A mutant of loops is a contact of a valid query.
void check_trim_moves(Draw& d) {
  Contact q = supposed(
      contact_of(d.coin() ? draw_trimmed_contact(d) : supposed(draw_contact(d, {-2, 2, 3}))));
  for (std::uint64_t left = 1 + d.choose(4); left > 0; --left) {
    if (Contact next = q; change_trim(next, d)) q = std::move(next);
  }
  const Case known = case_of(q);
  show(d, "mutant", known);
  const bool is_accepted = check_truth(known).has_value();
  CLAIM(is_accepted);
}

}  // namespace

std::vector<Property> trims_claims() {
  constexpr auto kPatch = "src/bezier/patch.hpp";
  constexpr auto kDomain = "src/bezier/trim_region.hpp";
  constexpr auto kChecker = "src/case/certificate.hpp";
  constexpr auto kCertified = "src/ccd/certified/tdibm_c.hpp";
  constexpr auto kRational = "src/ccd/rational/tdibm_rational.hpp";
  std::vector<Property> claims = {
      {"trims.meaning", "A trim means the same to generator, checker, files and fuzzers", kPatch,
       check_trim_meaning},
      {"trims.valid", "Loops that no patch may have are refused, naming the field",
       "src/bezier/trim.hpp", check_trim_valid},
      {"trims.orientation", "On which side of a line a point is, is exact for all doubles",
       "src/bezier/orientation.hpp", check_trim_orientation},
      {"trims.cells", "A cell is outside, or inside, iff all of it is, to methods and checker",
       kDomain, check_trim_cells},
      {"trims.whole_is_none", "A trim of all of the domain changes no bit of an answer", kDomain,
       check_trim_whole},
      {"trims.traces", "A contact in the region is followed as that of the whole patches", kDomain,
       check_trim_traces},
      {"trims.hits", "A hit's parameters are within the precision of the region", kCertified,
       check_trim_hits},
      {"trims.decision_is_proven", "What the oracle says of trimmed patches, the checker accepts",
       "src/certify/oracle/oracle.hpp", check_trim_decision},
      {"trims.hole", "A contact in a hole is none, by a proof that is none of the whole patch",
       kChecker, check_trim_hole},
      {"checker.refuses_wrong_outsides", "No whole patch is outside of its trim", kChecker,
       check_trim_outside_leaf},
      {"checker.refuses_boxes_outside", "No box that leaves a trim holds a contact", kChecker,
       check_trim_boxes},
      {"mutator.keeps_trims", "Changed loops are valid, and the contact is in their region",
       "fuzz/mutator/trim_moves.hpp", check_trim_moves},
  };
  add_contact_claims(claims, "tdibm-c", "trimmed", "of trimmed patches", kCertified,
                     draw_trimmed_contact);
  add_contact_claims(claims, "tdibm-rational", "trimmed", "of trimmed patches", kRational,
                     draw_trimmed_contact);
  return claims;
}

}  // namespace ccdfuzz
