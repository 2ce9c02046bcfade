#include "finds/minimise.hpp"

#include <algorithm>
#include <tuple>
#include <vector>

#include "case/scale.hpp"
#include "certify/checker/check_case.hpp"
#include "certify/checker/check_witness.hpp"
#include "certify/oracle/decide_linear.hpp"
#include "certify/oracle/find_plane.hpp"
#include "certify/oracle/oracle.hpp"
#include "finds/simplify.hpp"
#include "fuzz/mutator/repair.hpp"
#include "generators/bodies.hpp"
#include "generators/shaped/features.hpp"

namespace ccdfuzz {

namespace {

/// How many ways to repair a broken contact are looked at; there are about as many.
constexpr std::uint64_t kRepairs = 6;

/// What of a contact stays: the feature of each patch that it lies on, and whether it comes after
/// the start.
using ContactPlace = std::tuple<Feature, Feature, bool>;

ContactPlace place_of(const Contact& q) {
  const auto& [a, b] = q.query.patches;
  return {feature_at(a.shape, q.uv[0]), feature_at(b.shape, q.uv[1]), q.t.sign() > 0};
}

/// With a budget that allows for hundreds of them.
Decision decided_in_few_pops(const Query& query) {
  return decide(query, {.max_pops = kEnoughPops, .max_tree_nodes = kEnoughPops});
}

/// The same of a decision that they touch.
ContactPlace place_of(const Query& query, const Decision& decision) {
  std::array<Feature, 2> features;
  for (size_t side = 0; side < 2; ++side) {
    const auto& [u, v] = decision.uv[side];
    features[side] =
        feature_at(query.patches[side].shape, {from_double<Dyadic>(u), from_double<Dyadic>(v)});
  }
  const std::optional<Rational>& clear = decision.truth.clear_until;
  return {features[0], features[1], clear && *clear > 0};
}

/// Whether a contact is at an edge or a corner of neither patch, but where that is all of it.
bool is_inside(const Witness& witness, const Query& query) {
  for (size_t side = 0; side < 2; ++side) {
    const auto& [u, v] = witness.uv[side];
    const ShapeKind kind = query.patches[side].shape.kind;
    if (kind == ShapeKind::kCurve && (u == 0 || u == 1)) return false;
    if (kind == ShapeKind::kTriangle && (u == 0 || v == 0 || u + v == 1)) return false;
  }
  return true;
}

/// Whether the patches come as near as the separation of the query, where it has one.
bool is_within_separation(const Contact& q) {
  return q.query.separation > 0 && is_valid(q.query) && check_witness(q.query, q.witness());
}

class Minimiser {
 public:
  Minimiser(const Case& found, Outcome failure, const std::function<bool(const Case&)>& still_fails,
            const MinimiseOptions& options)
      : found_(found), failure_(failure), still_fails_(still_fails), options_(options) {}

  Minimised run() {
    if (!start()) return {found_, 0};
    bool simpler = true;
    while (simpler && !ended()) {
      simpler = false;
      offer_simpler(best_, [&](const Contact& form) {
        const bool taken = take(form);
        simpler = simpler || taken;
        return taken;
      });
    }
    return {best_case_, trials_};
  }

 private:
  bool start() {
    if (!is_failure(failure_)) return false;
    best_ = {found_.query, Dyadic(), {}};
    if (is_false_negative(failure_)) {
      // Many contacts of linear patches come at a time that is no fraction.
      const bool is_decided = is_decided_exactly(found_.query);
      const auto witnessed = is_decided ? contact_of(found_) : near_contact_of(found_);
      keeps_witness_ = witnessed.has_value();
      if (witnessed) best_ = *witnessed;
      if (!witnessed && !is_decided) {
        if (!found_.truth.contact_box) return false;
        place_ = place_of(found_.query, decided_in_few_pops(found_.query));
      }
    }
    if (is_of_bodies(found_.query) && failure_ != Outcome::kError) {
      const std::optional<Case> decided = case_of_bodies(found_.query);
      if (decided) contact_ = decided->origin.contact;
    }
    rank_ = simplicity_of(best_);
    if (keeps_witness_) {
      place_ = place_of(best_);
    } else if (const auto& w = found_.truth.witness; w && !is_inside(*w, found_.query)) {
      if (const auto near = near_contact_of(found_)) place_ = place_of(*near);
    }
    are_floats_ = is_binary32(found_.query);
    return true;
  }

  bool ended() const { return trials_ >= options_.max_trials || options_.stop(); }

  /// The case of a query without a witness, whose truth is decided unless the failure is an error.
  /// Nothing where that is not a truth about which methods fail so.
  std::optional<Case> decided(const Query& query) const {
    Case value{query, {}, {}};
    if (failure_ == Outcome::kError) return value;
    if (is_of_bodies(query)) {
      const std::optional<Case> made = case_of_bodies(query);
      if (!made || made->origin.contact != contact_) return std::nullopt;
      value = *made;
    } else if (is_decided_linearly(query)) {
      value.truth = decide_linear(query, {}).truth;
    } else if (is_false_negative(failure_)) {
      const Decision decision = decided_in_few_pops(query);
      if (decision.truth.collides != true || place_of(query, decision) != place_) {
        return std::nullopt;
      }
      return Case{query, decision.truth, {}};
    } else if (const auto* plane = clearance_of<MovingPlane>(best_case_.truth);
               plane && query.t_max > 0) {
      // As far past t_max as before.
      const Rational until = plane->until / exact(best_case_.query.t_max) * exact(query.t_max);
      value.truth.clearance = find_plane_near(query, *plane, until);
      conclude(query, value.truth);
    } else if (clearance_of<MissTree>(best_case_.truth)) {
      value.truth = absence_by_tree(query);
    }
    if (value.truth.collides != is_false_negative(failure_)) return std::nullopt;
    return is_in_place(value) ? std::optional(value) : std::nullopt;
  }

  /// Whether the contact of a decided case is on the features of the witness of `found`, or inside.
  /// What is missed at a time that is no fraction is missed inside.
  bool is_in_place(const Case& value) const {
    const std::optional<Witness>& witness = value.truth.witness;
    if (!place_) return !witness || is_inside(*witness, value.query);
    const std::optional<Contact> near = near_contact_of(value);
    return near && place_of(*near) == place_;
  }

  std::optional<Case> as_case(const Contact& q) const {
    // A query of a time does not become one of an instant.
    if (q.query.t_max == 0 && found_.query.t_max > 0) return std::nullopt;
    std::optional<Case> value = keeps_witness_ ? case_of(q) : decided(q.query);
    if (!value || (keeps_witness_ && !check_witness(q.query, *value->truth.witness))) {
      return std::nullopt;
    }
    value->origin = found_.origin;
    value->asked = found_.asked;
    return value;
  }

  /// The forms as which an edited query has its contact, simpler than the best, simplest first.
  std::vector<std::pair<Simplicity, Contact>> whole_forms(const Contact& form) const {
    std::vector<std::pair<Simplicity, Contact>> forms;
    const std::uint64_t ways = keeps_witness_ ? kRepairs : 1;
    for (std::uint64_t way = 0; way < ways; ++way) {
      Contact whole = form;
      Draw random{Random(way)};
      if (keeps_witness_ && place_of(whole) != place_) continue;
      if (keeps_witness_ && !is_within_separation(whole) && !repair(whole, random)) continue;
      if (!(whole.query.t_max >= 0) || !is_valid(whole.query)) continue;
      const Simplicity rank = simplicity_of(whole);
      if (!(rank < rank_)) continue;
      const auto is_it = [&](const auto& f) { return f.second.query == whole.query; };
      if (std::ranges::none_of(forms, is_it)) forms.emplace_back(rank, std::move(whole));
    }
    std::ranges::sort(forms, {}, &std::pair<Simplicity, Contact>::first);
    return forms;
  }

  bool take(const Contact& form) {
    for (auto& [rank, whole] : whole_forms(form)) {
      if (are_floats_ && !is_binary32(whole.query)) continue;
      if (ended()) return false;
      std::optional<Case> value = as_case(whole);
      if (!value) continue;
      ++trials_;
      if (!still_fails_(*value)) continue;
      best_ = std::move(whole);
      best_case_ = *std::move(value);
      rank_ = rank;
      return true;
    }
    return false;
  }

  const Case& found_;
  Outcome failure_;
  const std::function<bool(const Case&)>& still_fails_;
  const MinimiseOptions& options_;
  Contact best_;
  Case best_case_ = found_;
  Simplicity rank_;
  std::optional<ContactPlace> place_;  ///< of a witness that is kept, or is not inside; or of a box
  std::string contact_;                ///< its class, as case_of_bodies tells it
  bool keeps_witness_ = false;
  bool are_floats_ = false;
  std::uint64_t trials_ = 0;
};

constexpr std::uint64_t kTrialsOfAHang = 6;
/// A taken form of a miss or late hit has this share of the greatest depth so far, relative to its
/// size.
constexpr double kDepthKept = 0.5;

/// How deep patches pass through each other in what an answer overlooks (depth_of), as a share of
/// their largest coordinate; 0 where that is not measured.
double relative_depth(const CheckedCase& known, const Judged& judged) {
  const double size = largest_coordinate(known.query());
  return size > 0 ? depth_of(known, judged).value_or(0) / size : 0;
}

}  // namespace

Minimised minimise(const Case& found, Outcome failure,
                   const std::function<bool(const Case&)>& still_fails,
                   const MinimiseOptions& options) {
  return Minimiser(found, failure, still_fails, options).run();
}

Minimised minimise(const Case& found, const Failure& failure, Asker& asker,
                   MinimiseOptions options) {
  if (failure.cause == "hang") options.max_trials = std::min(options.max_trials, kTrialsOfAHang);
  Case start = found;
  start.asked = asked_with(asker.search());
  start.expect.clear();
  // What becomes deeper stays so, and a deep one is left, no matter of rounding.
  double deepest = 0;
  const bool may_be_deep = is_false_negative(failure.outcome);
  if (may_be_deep) {
    const CheckedCase known = checked_or_unknown(start);
    deepest = relative_depth(known, asker.ask(failure.who, known));
  }
  const bool is_admitted = options.admits(start);
  Minimised minimised = minimise(
      start, failure.outcome,
      [&](const Case& simpler) {
        if (is_admitted && !options.admits(simpler)) return false;
        const CheckedCase known = checked_or_unknown(simpler);
        const Judged judged = asker.ask(failure.who, known);
        if (asker.failure(failure.who, simpler, judged) != failure) return false;
        const double depth = may_be_deep ? relative_depth(known, judged) : 0;
        if (depth < kDepthKept * deepest) return false;
        deepest = std::max(deepest, depth);
        return true;
      },
      options);
  minimised.value.origin.name.clear();
  minimised.value.expect[failure.who] = {failure.outcome, failure.cause};
  return minimised;
}

}  // namespace ccdfuzz
