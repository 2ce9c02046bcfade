#pragma once

#include <string>

#include "case/answer.hpp"
#include "case/checked_case.hpp"

namespace ccdfuzz {

/// What a method claims of an answer beyond it. As they stand here: a contact counts at 0 and at
/// t_max, and nothing is counted in its favour.
struct AnswerTerms {
  bool closed_t_max = true;
  bool contact_at_zero = true;
  /// A hit at most this much after the contact is not late. ≥ 0, finite.
  double time_tolerance = 0;
  /// A hit is right if the points at uv are at most this far apart at toi. ≥ 0, finite.
  double space_tolerance = 0;
  /// A miss or late hit of bodies is right if what it overlooks is no deeper. ≥ 0, finite.
  double depth_tolerance = 0;
  /// A hit is right if a contact after t_max comes at most this much after it. ≥ 0, finite.
  double early_tolerance = 0;
  /// Patches that come nearer than this count as touching; not those that are as near from the
  /// start if contacts at 0 do not count. ≥ 0, finite.
  double kept_separation = 0;
  /// It is asked about bodies in the plane z = 0 alone.
  bool in_plane = false;
};

/// How an answer stands against the truth, every comparison exact:
///   not_asked       it refuses the query, whatever that holds
///   error           the answer is nonsense: a hit without toi, toi NaN or outside [0, t_max]
///   undecided       it says so
///   missed, late    a witness, box or root proves a contact by some t ≤ t_max (< t_max, and
///                   > 0, where the terms leave an end out); the answer is a miss, or a hit later
///                   than its time tolerance. Or the two points of a witness, of any time, come
///                   nearer than the separation it keeps, and it is a miss, or a hit later than so
///   false_positive  a hit, and absence of contact on [0, t_max] is proven (is_clear); the patches
///                   at uv and toi are farther apart than the space tolerance (a uv outside of the
///                   domain is moved to its edge), or the certificate of bodies shows that they
///                   are (apart_at). With an early tolerance,
///                   absence is proven for so long after toi, too
///   unknown         neither contact nor absence on [0, t_max] is proven, whatever the case says of
///                   them. Or a hit may come within the early tolerance before a contact, or it has
///                   a space tolerance and does not say where. Where the terms leave t_max out,
///                   absence on [0, t_max) is enough for a miss
///   correct         anything else
/// The contact counts first.
Outcome judge(const CheckedCase& known, const Answer& answer, const AnswerTerms& terms = {});

/// Until when a contact makes an earlier hit right: the early tolerance after it, but no longer
/// than the patches move.
Rational early_until(const Query& query, const Answer& answer, const AnswerTerms& terms);

/// How patches come to touch: the distance of the two points of a witness falls linearly, from the
/// root of `squared` at t = 0 to 0 at `until`.
struct Approach {
  Rational squared;
  Rational until;
};

/// That of a case whose witness is proven. Nothing without a witness, of bodies, or if the query
/// has a separation.
std::optional<Approach> approach_of(const Case& value);

/// The time since when patches are proven nearer than the separation that is kept, rounded down.
/// Nothing if they do not come so near before a time, or if that does not count.
std::optional<Rational> nearer_since(const CheckedCase& known, const AnswerTerms& terms,
                                     const Rational& before);

/// How far bodies are apart at t beyond their radii and the separation. It is a lower bound, by
/// their clearance; at most 0 where that shows nothing. Requires a clearance that covers t ≥ 0.
double apart_at(const CheckedCase& known, double t);

/// An answer and how it stands against its truth.
struct Judged {
  Answer answer;
  Outcome outcome = Outcome::kUnknown;
  /// For an error: its kind, such as "hang". Without a name from the method it is "exception" or
  /// "nonsense".
  std::string error;
  /// For a late hit: as of delay_of.
  double late_by = 0;
  /// For a miss or late hit of bodies or linear patches, where it was asked for. It is how deep
  /// they pass through each other in the time that is overlooked, at least.
  double depth = 0;
  AnswerTerms terms = {};  ///< of the answer
  /// For a false positive of bodies: as of apart_at.
  double apart = 0;

  /// What a row of JSON says of it, behind the case and the method. Written only.
  static void fields(auto& archive, const Judged& judged) {
    const Answer& answer = judged.answer;
    const bool is_hit = answer.verdict == Verdict::kHit;
    archive("verdict", answer.verdict);
    archive("toi", answer.has_toi() ? answer.toi : std::nullopt);
    archive("uv", is_hit && answer.has_uv ? std::optional(answer.uv) : std::nullopt);
    archive("outcome", judged.outcome);
    archive.optional("late_by", judged.late_by);
    archive.optional("depth", judged.depth);
    archive.optional("apart", judged.apart);
    if (is_false_negative(judged.outcome)) {
      archive.optional("depth_tolerance", judged.terms.depth_tolerance);
      archive.optional("time_tolerance", judged.terms.time_tolerance);
    }
    archive("pops", answer.pops);
    archive("seconds", answer.seconds);
    archive.optional("error", judged.error);
    archive.optional("note", answer.note);
  }
};
/// What `origin` of a find calls these two.
constexpr const char *kDepthAllowed = "depth_tolerance", *kTimeAllowed = "time_tolerance";

/// How long after the proven contact a late hit comes, rounded up. It is later than 0. Where the
/// patches came nearer than the separation that is kept, this counts from then.
double delay_of(const CheckedCase& known, const Answer& answer, const AnswerTerms& terms);

/// The same two patches asked up to another t_max ≥ 0, with what its truth then still says. Absence
/// of contact holds for a shorter time but says nothing of a longer one. A contact is proven only
/// from its time on. Expectations are dropped: they were of another query.
Case with_t_max(const Case& value, double t_max);

}  // namespace ccdfuzz
