#include "certify/oracle/oracle.hpp"

#include <fmt/format.h>

#include "base/fp_guard.hpp"
#include "base/time_limit.hpp"
#include "ccd/certified/tdibm_c.hpp"
#include "ccd/past_start.hpp"
#include "ccd/rational/tdibm_rational.hpp"
#include "ccd/search.hpp"
#include "certify/checker/check_truth.hpp"
#include "certify/checker/check_witness.hpp"
#include "certify/checker/work_done.hpp"
#include "certify/linear/first_contact.hpp"
#include "certify/oracle/build_tree.hpp"
#include "certify/oracle/decide_bodies.hpp"
#include "certify/oracle/decide_linear.hpp"
#include "certify/oracle/find_contact.hpp"
#include "certify/oracle/find_plane.hpp"
#include "certify/oracle/is_readable.hpp"
#include "certify/oracle/rational_roots.hpp"

namespace ccdfuzz {

namespace {

class Deciding {
 public:
  /// clearance: what is proven already.
  Deciding(const Query& query, const OracleOptions& options, std::optional<Clearance> clearance)
      : query_(query),
        options_(options),
        deadline_(SearchOptions{.max_seconds = options.max_seconds, .clock = options.clock}) {
    out_.truth.clearance = std::move(clearance);
  }

  Decision run() {
    try {
      if (options_.known && options_.known->t <= exact(query_.t_max)) {
        CCDFUZZ_VERIFY(check_witness(query_, *options_.known));
        consider(*options_.known);
      }
      search();
      prove_clear();
    } catch (const OutOfTime&) {
      out_.note = kOutOfTime;
    }
    conclude(query_, out_.truth);
    return std::move(out_);
  }

 private:
  template <class Method>
  Answer ask(double precision) {
    thread_local Method method;
    // A pop of tdibm-rational costs about as much as 12 of tdibm-c.
    const bool is_exact = std::is_same_v<Method, TdibmRational>;
    const std::uint64_t pops = is_exact ? options_.max_pops / 12 : options_.max_pops;
    const Answer answer = method.answer(query_, {.precision = precision,
                                                 .max_pops = pops,
                                                 .max_bytes = options_.max_bytes,
                                                 .max_seconds = deadline_.left(),
                                                 .clock = options_.clock});
    out_.pops += answer.pops;
    if (answer.verdict != Verdict::kMiss && answer.toi) clear_ = std::max(clear_, *answer.toi);
    if (answer.verdict == Verdict::kUndecided) out_.note = answer.note;
    return answer;
  }

  /// Looks for a contact, at finer and finer precision. An exact witness or a miss ends the search;
  /// a contact box does once the precision is fine.
  void search() {
    for (const double precision : {0x1p-12, 0x1p-20, 0x1p-28, 0x1p-38}) {
      const Answer answer = ask<TdibmC>(precision);
      if (settles(answer, precision)) return;
      if (answer.verdict == Verdict::kUndecided) break;
    }
    if (out_.truth.contact_by()) return;
    for (const double precision : {0x1p-14, 0x1p-24}) {
      const Answer answer = ask<TdibmRational>(precision);
      if (settles(answer, precision) || answer.verdict == Verdict::kUndecided) return;
    }
  }

  bool settles(const Answer& answer, double precision) {
    missed_ = answer.verdict == Verdict::kMiss;
    if (answer.verdict != Verdict::kHit) return missed_;
    const ContactGuess guess{answer.uv, *answer.toi, precision};
    Truth& truth = out_.truth;
    if (const auto witness = find_witness(query_, guess)) {
      consider(*witness);
      return true;
    }
    const bool touching = query_.separation == 0;
    const auto box = touching ? find_contact_box(query_, guess) : std::nullopt;
    if (box && (!truth.contact_by() || box->until() < *truth.contact_by())) {
      truth.contact_box = box;
      truth.witness.reset();
      out_.uv = answer.uv;
    }
    constexpr double kFine = 0x1p-20;
    return truth.contact_by() && precision <= kFine;
  }

  /// Keeps a witness unless an earlier contact is known.
  void consider(const Witness& witness) {
    const std::optional<Rational> by = out_.truth.contact_by();
    if (by && *by < witness.t) return;
    out_.truth.contact_box.reset();
    out_.truth.witness = witness;
    for (size_t s = 0; s < 2; ++s) {
      for (size_t k = 0; k < 2; ++k) out_.uv[s][k] = round_down(witness.uv[s][k]);
    }
  }

  /// True, too, if it is proven already.
  bool try_tree(const Rational& until, std::uint64_t max_nodes) {
    if (out_.truth.clearance && covers(*out_.truth.clearance, until)) return true;
    std::optional<MissTree> tree = build_miss_tree(query_, until, max_nodes);
    if (!tree) return false;
    out_.truth.clearance = *std::move(tree);
    return true;
  }

  void prove_clear() {
    const Rational t_max = exact(query_.t_max);
    if (missed_) {
      if (try_tree(t_max, options_.max_tree_nodes)) return;
      out_.note = "separated, but by too large a tree";
      clear_ = query_.t_max;
    }
    const auto& witness = out_.truth.witness;
    if (witness && witness->t > 0) {
      const auto& clearance = out_.truth.clearance;
      if (clearance && until_of(*clearance) >= witness->t) return;
      if (auto plane = find_plane(query_, *witness)) {
        out_.truth.clearance = *plane;
        return;
      }
    }
    const std::optional<Rational> contact = out_.truth.contact_by();
    const auto& wanted = options_.wanted_clear;
    if (wanted && *wanted > 0 && !(contact && *contact <= *wanted)) {
      if (try_tree(*wanted, options_.max_tree_nodes)) return;
    }
    // Trees grow as `until` nears the contact. If one is too large, try an earlier time. These
    // trees do not decide the query, so each gets a quarter of the nodes.
    constexpr std::uint64_t kShare = 4;
    for (const double slack : {0x1p-20, 0x1p-14, 0x1p-10, 0x1p-7, 0x1p-4, 0x1p-2}) {
      const double before = clear_ - slack * query_.t_max;
      // Near the start, half of the time. It is rounded down to 32 bits.
      const Rational until = exact(before > 0 ? before : 0.5 * clear_);
      if (until > 0 && try_tree(rounded_down(until, power_below(until) * power_of_two(-30)),
                                options_.max_tree_nodes / kShare)) {
        return;
      }
      if (before <= 0) return;
    }
  }

  const Query& query_;
  const OracleOptions& options_;
  Deadline deadline_;
  Decision out_;
  double clear_ = 0;  ///< the searches found no contact before
  bool missed_ = false;
};

Decision undecided(const InputError& why, std::uint64_t pops) {
  Decision decision;
  decision.pops = pops;
  decision.note = why.message();
  return decision;
}

Decision find_truth(const Query& query, const OracleOptions& options) {
  const TimeLimit limit(options.max_seconds, options.clock);
  try {
    if (is_of_bodies(query)) return decide_bodies(query, options);
    std::optional<Clearance> clearance;
    if (linear::is_linear(query)) {
      Decision found = decide_linear(query, options);
      if (found.truth.collides) return found;
      clearance = std::move(found.truth.clearance);
    }
    return Deciding(query, options, std::move(clearance)).run();
  } catch (const OutOfTime&) {
    return undecided({"", kOutOfTime}, 0);
  }
}

/// Whether the checker accepts all that was found, and files may hold it. Planes between bodies it
/// accepted one by one, as they were found.
Result<void> check_found(const Query& query, const Decision& found, const OracleOptions& options) {
  if (!is_readable(found.truth)) {
    return tl::unexpected(InputError{
        "", fmt::format("a proof has a number of more than {} digits", kMaxRationalDigits), true});
  }
  const TimeLimit limit(options.max_seconds, options.clock);
  try {
    CCDFUZZ_TRY_VOID(check_truth({query, found.truth, {}, {}}));
    const auto& clearance = found.truth.clearance;
    if (!clearance || std::holds_alternative<BodyPlanes>(*clearance)) return {};
    return check_clearance(query, *clearance);
  } catch (const OutOfTime&) {
    return tl::unexpected(InputError{"", kOutOfTime, true});
  }
}

}  // namespace

void conclude(const Query& query, Truth& truth) {
  const Rational t_max = exact(query.t_max);
  const std::optional<Rational> contact = truth.contact_by();
  if (contact && *contact <= t_max) truth.collides = true;
  if (!truth.clearance) return;
  truth.clear_until = until_of(*truth.clearance);
  if (!covers(*truth.clearance, t_max)) return;
  CCDFUZZ_VERIFY(truth.collides != true);  // else a proof of ours is wrong
  truth.collides = false;
  truth.proof = proof_word(*truth.clearance);
}

Truth absence_by_tree(const Query& query) {
  // Measured: 47,266 nodes for two triangle(2), which have 12 control points, took 5 µs each. Per
  // node the time grows with the square of that number: two tensor(8,8) took 240 times as long.
  const std::uint64_t points =
      query.patches[0].positions.size() + query.patches[1].positions.size();
  const std::uint64_t max_nodes = 200'000 / (points * points);
  Truth truth;
  truth.clearance = build_miss_tree(query, exact(query.t_max), max_nodes);
  conclude(query, truth);
  return truth;
}

bool is_decided_linearly(const Query& query) {
  return linear::is_linear(query) && !is_trimmed(query);
}

bool is_decided_exactly(const Query& query) {
  return is_of_bodies(query) || is_decided_linearly(query);
}

Decision decide(const Query& query, const OracleOptions& options) {
  const FpGuard guard;
  const UncountedWork own;
  if (const auto fault = fault_of(query)) return undecided(*fault, 0);
  Decision found = find_truth(query, options);
  if (found.truth.collides) {
    found.note.clear();
  } else if (found.note.empty()) {
    found.note = "no certificate found";
  }
  // Nothing leaves the oracle that the checker does not accept, that takes it too long, or that
  // files may not hold.
  const Result<void> checked = check_found(query, found, options);
  if (checked) return found;
  CCDFUZZ_VERIFY(checked.error().is_limit);  // else a proof of ours is wrong
  // A contact stands without the proof of the time before, where that takes too long.
  if (found.truth.collides == true && found.truth.clearance) {
    found.truth.clearance.reset();
    found.truth.clear_until.reset();
    if (check_found(query, found, options)) return found;
  }
  return undecided(checked.error(), found.pops);
}

Answer Oracle::answer(const Query& query, const SearchOptions& options) {
  if (!is_question(query, options)) return refusal(query, options);
  OracleOptions limits;
  limits.max_pops = options.max_pops;
  limits.max_bytes = options.max_bytes;
  limits.max_seconds = options.max_seconds;
  limits.clock = options.clock;
  const Decision decision = decide(query, limits);
  Answer answer;
  answer.pops = decision.pops;
  answer.note = decision.note;
  const auto& collides = decision.truth.collides;
  if (collides != false) {
    answer.verdict = collides ? Verdict::kHit : Verdict::kUndecided;
    answer.toi = round_down(decision.truth.clear_until.value_or(0));
    answer.uv = decision.uv;
  } else {
    answer.verdict = Verdict::kMiss;
  }
  return past_start(query, std::move(answer));
}

}  // namespace ccdfuzz
