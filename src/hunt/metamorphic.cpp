#include "hunt/metamorphic.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "bezier/exact_patch.hpp"
#include "bezier/restrict.hpp"
#include "case/mesh.hpp"
#include "case/scale.hpp"
#include "certify/checker/check_case.hpp"
#include "certify/checker/check_linear.hpp"
#include "certify/oracle/oracle.hpp"
#include "certify/oracle/outcome_of.hpp"
#include "fuzz/mutator/mutate_query.hpp"
#include "generators/similar.hpp"
#include "hunt/draw.hpp"
#include "method/method.hpp"
#include "method/setting.hpp"
#include "numeric/products.hpp"
#include "properties/show.hpp"

namespace ccdfuzz {

namespace {

/// A query that asks some of what another does.
struct Part {
  Query query;
  double begins = 0;  ///< its t = 0, as a time of the other
};

/// Queries that together ask what another does: it has a contact iff one of them has.
struct Related {
  std::vector<Part> parts;     ///< in the order in which they begin
  Similarity change = {};      ///< of what units theirs are
  bool is_same_motion = true;  ///< they are as ordinary as the other, but for their sizes
  bool is_reversed = false;    ///< they touch first where the other does last
};

/// nullopt: the query does not become that, or a number of it would be no double.
using Relation = std::optional<Related>(const Query& query, Draw& d);

/// Exact, as contact is symmetric.
std::optional<Related> in_other_order(const Query& query, Draw&) {
  return Related{{{swapped(query)}}};
}

/// Exact, as permuting and negating coordinates rounds nothing. No one-sided mesh is mirrored.
std::optional<Related> in_a_mirror(const Query& query, Draw& d) {
  const int by = d.integer(0, 2), axis = d.integer(0, 3);
  const std::optional<int> mirrored = axis < 3 ? std::optional(axis) : std::nullopt;
  for (const MovingPatch<double>& patch : query.patches) {
    if (patch.turn || (patch.one_sided && mirrored)) return std::nullopt;
  }
  return Related{{{on_other_axes(query, by, mirrored)}}};
}

Vec3<double> draw_small(Draw& d, bool in_plane) {
  const int exponent = d.integer(-4, 4);
  Vec3<double> v{0, 0, 0};
  for (int k = 0; k < (in_plane ? 2 : 3); ++k) v[k] = std::ldexp(d.integer(-8, 8), exponent);
  return v;
}

/// A common shift and velocity keep all differences, and powers of two change exponents alone:
/// exact where no number is rounded. Not both, so that no sizes are small beside the numbers.
std::optional<Related> in_other_units(const Query& query, Draw& d) {
  Related out;
  if (d.coin()) {
    out.change.shift = draw_small(d, is_in_plane(query));
    out.change.drift = draw_small(d, is_in_plane(query));
  } else {
    out.change.space = d.integer(-8, 8);
    out.change.time = has_ends(query) ? 0 : d.integer(-8, 8);
  }
  std::optional<Query> moved = similar(query, out.change);
  if (!moved) return std::nullopt;
  out.parts.push_back({*std::move(moved)});
  return out;
}

/// t → t_max − t passes the same places, exactly where those at t_max are doubles. A one-sided mesh
/// would be touched from behind.
std::optional<Related> reversed(const Query& query, Draw&) {
  std::optional<Query> back = begun_at(query, exact(query.t_max));
  if (!back || query.patches[0].one_sided || query.patches[1].one_sided) return std::nullopt;
  for (MovingPatch<double>& patch : back->patches) {
    for (Vec3<double>& v : patch.velocities) v = Vec3<double>(0, 0, 0) - v;
  }
  return Related{{{*std::move(back)}}, {}, false, true};
}

/// [0, t_max/2], and the rest from the places at its start: exact where those are doubles.
std::optional<Related> in_halves(const Query& query, Draw&) {
  const double half = query.t_max / 2;
  std::optional<Query> rest = begun_at(query, exact(half));
  if (!rest || half == 0 || 2 * half != query.t_max) return std::nullopt;
  Query first = query;
  first.t_max = rest->t_max = half;
  return Related{{{std::move(first)}, {*std::move(rest), half}}, {}, false};
}

/// The hull with one more point, midway between two of its own.
std::optional<MovingPatch<double>> with_middle(MovingPatch<double> hull, Draw& d) {
  const std::size_t count = hull.positions.size();
  if (count < 2) return std::nullopt;
  const std::size_t first = d.below(count), step = 1 + d.below(count - 1);
  const Vec3<double> a = hull.positions[first], b = hull.positions[(first + step) % count];
  Vec3<double>& middle = hull.positions.emplace_back();
  for (int k = 0; k < 3; ++k) {
    const auto exactly = to_double_exactly((exact(a[k]) + exact(b[k])) / 2);
    if (!exactly) return std::nullopt;
    middle[k] = *exactly;
  }
  hull.shape = Shape::hull(static_cast<int>(hull.positions.size()));
  return hull;
}

/// The part of a patch over a cell. Requires neither weights nor loops.
std::optional<MovingPatch<double>> part_of(const MovingPatch<double>& patch, const Cell& cell) {
  const auto corners = exact_corners<Dyadic>(cell.corners(patch.shape));
  return to_doubles(restrict_to(exact_patch<Dyadic>(patch), corners));
}

/// The parts of a patch that a split at midpoints makes; the faces of a mesh, one by one; or a hull
/// with a point inside. Exact where no number is rounded.
std::optional<Related> refined(const Query& query, Draw& d) {
  Related out{{}, {}, false};
  if (has_mesh(query)) {
    const bool are_meshes = d.coin();  // some methods take no two convex bodies
    for (const size_t face : faces_there(query)) {
      Query part = of_face(query, face);
      if (are_meshes) {
        MovingPatch<double>& mesh = part.patches[mesh_side(query)];
        mesh.faces = {{0, 1, 2}};
        mesh.one_sided = query.patches[mesh_side(query)].one_sided;
      }
      out.parts.push_back({std::move(part)});
    }
    return out.parts.empty() ? std::nullopt : std::optional(std::move(out));
  }
  const bool is_point = query.patches[0].shape.kind == ShapeKind::kPoint;
  const size_t side = is_point ? 1 : d.below(2);
  const auto add = [&](const std::optional<MovingPatch<double>>& part) {
    if (!part) return false;
    out.parts.push_back({query});
    out.parts.back().query.patches[side] = *part;
    return true;
  };
  const MovingPatch<double>& whole = query.patches[side];
  if (is_of_bodies(query)) return add(with_middle(whole, d)) ? std::optional(out) : std::nullopt;
  const bool is_plain = whole.weights.empty() && whole.trim.empty();
  if (!is_plain || whole.shape.kind == ShapeKind::kPoint) return std::nullopt;
  for (int c = 0; c < whole.shape.child_count(); ++c) {
    if (!add(part_of(whole, Cell{}.child(whole.shape, c)))) return std::nullopt;
  }
  return out;
}

/// A method, and what it is asked about; for one thread.
struct Subject {
  explicit Subject(const std::string& spec)
      : info(value_or_throw(method_info(spec))),
        method(value_or_throw(make_method(spec))),
        ground(value_or_throw(narrowed({}, {spec}))),
        draws(0, ground, info.features) {}

  /// Discards what is neither a hit nor a miss: hunts find that.
  Answered answer(const Query& query) const {
    constexpr SearchOptions kSearch = {.max_pops = 1000};  // more would take seconds
    try {
      Answered given = method->answer(query, kSearch);
      const bool is_hit = given.verdict == Verdict::kHit && given.toi && *given.toi >= 0;
      if (given.verdict == Verdict::kMiss) given.toi.reset();
      if (is_hit || given.verdict == Verdict::kMiss) return given;
    } catch (const MethodFault&) {
      throw Discarded();
    }
    throw Discarded();
  }

  bool promises(const Query& query, bool is_same_motion) const {
    if (!ground.has(query) || !ground.ordinary) return ground.has(query);
    if (is_same_motion) return setting_of({query, {}, {}, {}}) != Setting::kExtreme;
    if (!is_of_bodies(query) && !is_linear_query(query)) return false;
    const std::optional<Case> decided = decided_case(query);
    return decided && ground.has(*decided);
  }

  /// What related queries say of the first one, in its units: the earliest of their hits.
  Answered carried_back(const Related& related, const CheckedCase& known) const {
    std::optional<Answered> first;
    const auto& [parts, change, is_same_motion, is_reversed] = related;
    for (const Part& part : parts) {
      if (first && first->toi && *first->toi <= part.begins) break;
      Answered given = answer(part.query);
      AnswerTerms& terms = given.terms;
      for (double* x : {&terms.space_tolerance, &terms.depth_tolerance, &terms.kept_separation}) {
        *x = std::ldexp(*x, -change.space);
      }
      for (double* x : {&terms.time_tolerance, &terms.early_tolerance}) {
        *x = std::ldexp(*x, -change.time);
      }
      given.has_uv = false;
      // Rounded down, nothing is late that is in time.
      if (given.toi) {
        const Rational unit = power_of_two(-change.time);
        given.toi = round_down(exact(part.begins) + exact(*given.toi) * unit);
      }
      if (!first || !first->toi || (given.toi && *given.toi < *first->toi)) {
        first = std::move(given);
      }
    }
    if (!is_reversed) return *std::move(first);
    std::swap(first->terms.closed_t_max, first->terms.contact_at_zero);
    // A hit of the last contact says nothing of the time of the first.
    const Rational end = exact(known.query().t_max);
    if (first->toi) first->toi = known.is_clear() ? round_down(end - exact(*first->toi)) : 0;
    return *std::move(first);
  }

  bool is_early(const CheckedCase& known, const Answered& hit) const {
    const AnswerTerms& terms = hit.terms;
    if (terms.space_tolerance > 0) {
      Query nearer = known.query();
      if (!is_of_bodies(nearer) && !is_linear_query(nearer)) return false;
      nearer.separation = round_up(exact(nearer.separation) + exact(terms.space_tolerance));
      nearer.t_max = round_up(exact(*hit.toi) + exact(terms.time_tolerance));
      return decide(nearer).truth.collides == false;
    }
    return terms.time_tolerance > 0 && known.clearance() != nullptr &&
           until_of(*known.clearance()) > exact(*hit.toi) + exact(terms.time_tolerance);
  }

  /// What is wrong with an answer beyond its tolerance.
  std::optional<std::string_view> fault_of(const CheckedCase& known, const Answered& answer,
                                           bool has_time) const {
    const Outcome outcome = outcome_of(known, answer, answer.terms, ground.ordinary);
    const bool is_late = is_false_negative(outcome);
    if (is_late || (outcome == Outcome::kFalsePositive && !info.claims_no_false_negative)) {
      return name_of(outcome);
    }
    if (info.claims_no_false_negative || !has_time || !answer.toi) return std::nullopt;
    return is_early(known, answer) ? std::optional("early") : std::nullopt;
  }

  MethodInfo info;
  std::unique_ptr<Method> method;
  HuntGround ground;
  Draws draws;
};

/// Whether two hits are farther apart than their tolerances together; of bodies that do not turn,
/// by the way that these move in between.
bool differ(const Query& query, const Answered& one, const Answered& other) {
  const Rational apart = abs(exact(*one.toi) - exact(*other.toi));
  if (apart <= exact(one.terms.time_tolerance) + exact(other.terms.time_tolerance)) return false;
  if (!is_of_bodies(query) || has_turns(query)) return true;
  const Vec3<Rational> velocity =
      exact(query.patches[0].velocities[0]) - exact(query.patches[1].velocities[0]);
  const Rational most = exact(one.terms.space_tolerance) + exact(other.terms.space_tolerance);
  return dot(velocity, velocity) * apart * apart > most * most;
}

/// One of a hunt, or a mutant of it where that is decided exactly.
CheckedCase draw_known(const Subject& subject, Draw& d) {
  Case drawn = subject.draws.any_case(d);
  const Query& query = drawn.query;
  const bool is_plainly_linear =
      is_linear_query(query) && !has_ends(query) && !is_trimmed(query) && query.separation == 0;
  if ((is_of_bodies(query) || is_plainly_linear) && d.coin()) {
    drawn.query = mutate_query(drawn.query, drawn.query, d);
    drawn = supposed(decided_case(subject.ground.fitted(std::move(drawn)).query));
  }
  suppose(subject.ground.has(drawn));
  return supposed(check_case(std::move(drawn)));
}

void check_relation(Draw& d, const std::string& spec, Relation* relate) {
  static thread_local std::map<std::string, Subject> subjects;
  const Subject& subject = subjects.try_emplace(spec, spec).first->second;
  const CheckedCase known = draw_known(subject, d);
  const Query& query = known.query();
  const Related related = supposed(relate(query, d));
  const bool has_time = !related.is_reversed;
  const auto contact = known.contact_by();
  for (const Part& part : related.parts) {
    suppose(subject.promises(part.query, related.is_same_motion));
  }
  const Answered one = subject.answer(query), other = subject.carried_back(related, known);
  // Who leaves out an end of a step may leave out what comes by the end of its first half.
  const double until_rest = related.parts.back().begins;
  suppose((one.terms.closed_t_max && one.terms.contact_at_zero) || until_rest == 0 || !contact ||
          *contact > exact(until_rest));
  // A contact that comes so little before the start is not known.
  suppose(has_time || !(other.terms.early_tolerance > 0) || !known.is_clear());
  show(d, "method", spec);
  show(d, "query", known.value());
  for (const Part& part : related.parts) show(d, "related", Case{part.query, {}, {}, {}});
  show(d, "toi", one.toi);
  const auto fault = show(d, "fault", subject.fault_of(known, one, has_time));
  show(d, "toi, carried back", other.toi);
  const auto other_fault = show(d, "fault, carried back", subject.fault_of(known, other, has_time));
  const bool answers_agree =
      one.verdict == other.verdict && (!one.toi || !has_time || !differ(query, one, other));
  const bool just_one_is_wrong = !answers_agree && fault.has_value() != other_fault.has_value();
  CLAIM(!just_one_is_wrong);
}

Property claim_of(const char* name, const char* claim, Relation* relate) {
  // Some answers of the paper's methods move with a mirror (tdibm.mirror).
  const std::vector<std::string> sound = every_method_but({}, &MethodInfo::claim_is_proven);
  Property made{std::string("metamorphic.") + name, claim, "src/hunt/metamorphic.hpp",
                [=](Draw& d) { check_relation(d, d.pick(sound), relate); }};
  made.check_of = [=](Draw& d, const std::string& spec) { check_relation(d, spec, relate); };
  return made;
}

}  // namespace

std::vector<Property> metamorphic_claims() {
  return {
      claim_of("swap", "No answer changes where the two are swapped", in_other_order),
      claim_of("axes", "No answer changes with other axes, or in a mirror", in_a_mirror),
      claim_of("units", "No answer changes with a common shift and velocity, or in other units",
               in_other_units),
      claim_of("reverse", "In reverse there is a contact iff there is one", reversed),
      claim_of("halves", "There is a contact iff there is one in a half of the time", in_halves),
      claim_of(
          "refined",
          "There is a contact iff a part of a patch has one, a face of a mesh, or a hull with a "
          "point inside",
          refined),
  };
}

}  // namespace ccdfuzz
