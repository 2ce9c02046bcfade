#pragma once

#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include "case/case.hpp"
#include "case/judge.hpp"
#include "case/taxonomy.hpp"
#include "numeric/dyadic.hpp"
#include "numeric/exact_scalars.hpp"

namespace ccdfuzz {

/// A query and a contact of it: doubles for the patches, dyadic numbers for where and when they
/// touch.
/// Invariant of a whole one: patch 1 at uv[0] and patch 2 at uv[1] are at one point at t, exactly,
/// and 0 ≤ t ≤ query.t_max; and is_in_trims.
struct Contact {
  Query query;
  Dyadic t;
  std::array<Uv<Dyadic>, 2> uv;

  /// The weights of patch `side`'s control points at the contact, of a rational patch its own times
  /// those of Bernstein.
  std::vector<Dyadic> weights(size_t side) const;
  /// Their sum: 1 of a polynomial patch.
  Dyadic weight(size_t side) const;
  /// The point of patch `side` that is in contact, times weight(side).
  Vec3<Dyadic> point(size_t side) const;
  /// From the point of patch 2 to that of patch 1, times both weights.
  Vec3<Dyadic> offset() const;
  /// The contact, as truths hold it.
  Witness witness() const;
};

/// Both places of the contact are doubles in the trims of their patches, or where there is none.
bool is_in_trims(const Contact& q);

/// The witnessed contact of a case. nullopt if its truth has no witness within t_max, or one of
/// bodies. Likewise if the witness is not dyadic, or its points are apart.
std::optional<Contact> contact_of(const Case& known);
/// One to be made whole: as near to the witness as fractions over 32 are, where that is not dyadic.
/// nullopt if there is no witness within t_max, or one of bodies, or the fractions leave a
/// triangle's inside.
std::optional<Contact> near_contact_of(const Case& known);

/// Where on the patches the contact lies. A curve is an edge, its ends and a point are corners.
ContactClass contact_class_of(const Contact& q);

/// A point that falls on a line: what an empty corpus begins with where no drawn contact fits.
Contact falling_point();

/// A truth value that says why. RapidCheck, Catch2 and streams show the reason.
struct Explained {
  bool holds = false;
  std::string why;

  explicit operator bool() const { return holds; }
  Explained operator!() const { return {!holds, why}; }
  friend std::ostream& operator<<(std::ostream& out, const Explained& e) { return out << e.why; }
};

/// True iff the answer lets the contact through: by a miss, or by a hit after
/// t + terms.time_tolerance. A hit at what is no time in [0, t_max], such as -1 or NaN, does so,
/// too. Contacts at 0 and at t_max count unless the terms say that they do not. Never of what is
/// undecided or refused. The reason has both times: "answered hit at 0.5 (0x1p-1); they touch at
/// t = 0.25 (0x1p-2)". Errors: throws std::invalid_argument for a tolerance that is not finite or
/// below 0.
Explained is_false_negative(const Contact& contact, const Answer& answer,
                            const AnswerTerms& terms = {});

/// True iff the answer is missed, late, a false positive or nonsense, by what of the case is proven
/// (outcome_of). This serves all cases: with ends, with a separation, of bodies. The reason has the
/// outcome, the answer and the proof: "missed: answered miss; contact by t = 0.25 (0x1p-2)". Only
/// nonsense is wrong where the case proves nothing, or where what it says does not hold. Errors: as
/// is_false_negative.
Explained is_wrong(const Case& known, const Answer& answer, const AnswerTerms& terms = {});

/// A case that says of the query what is proven: the witness, and nothing of the time before it.
Case case_of(const Contact& q);

}  // namespace ccdfuzz
