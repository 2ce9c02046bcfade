#pragma once

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "case/certificate.hpp"
#include "case/outcome.hpp"
#include "case/query.hpp"
#include "numeric/rational.hpp"

namespace ccdfuzz {

/// An exact contact: patch 1 at uv[0] and patch 2 at uv[1] coincide at time t. A witness of bodies
/// has weights of their hulls' points instead, and uv is 0: the points that they make are near
/// enough.
struct Witness {
  Rational t;
  std::array<Uv<Rational>, 2> uv;
  std::array<std::vector<Rational>, 2> weights = {};

  friend bool operator==(const Witness&, const Witness&) = default;
};

/// The proofs of absence of contact: a moving plane (P), a tree of separating axes (T), or a run of
/// the rational method that `ccdfuzz verify` repeats. Also the checker's own decision of linear
/// patches (L), a direction that keeps bodies apart (K), planes between bodies (N), and directions
/// for the faces of a mesh (F).
inline constexpr std::array<std::string_view, 7> kProofWords = {
    "P", "T", "rational-tdibm", "L", "K", "N", "F"};
constexpr bool is_proof_word(std::string_view word) {
  return std::find(kProofWords.begin(), kProofWords.end(), word) != kProofWords.end();
}

/// What is known of a query, up to its t_max or, by clear_until and witness, beyond; and by what
/// proof.
struct Truth {
  std::optional<bool> collides;         ///< absent: unknown
  std::optional<Witness> witness;       ///< this, contact_box or contact_root, if collides
  std::optional<Rational> clear_until;  ///< no contact for 0 ≤ t < clear_until is proven
  std::optional<std::string> proof;     ///< one of kProofWords; needed if not collides
  std::optional<ContactBox> contact_box;
  std::optional<ContactRoot> contact_root;
  std::optional<Clearance>
      clearance;  ///< needed if proof is "P", "T", "L", "K", "N" or "F", and of that kind

  /// The earliest time by which a contact is known to have come, whatever t_max is.
  std::optional<Rational> contact_by() const {
    std::optional<Rational> by;
    const auto consider = [&by](const Rational& t) {
      if (!by || t < *by) by = t;
    };
    if (witness) consider(witness->t);
    if (contact_box) consider(contact_box->until());
    if (contact_root) consider(contact_root->by);
    return by;
  }

  friend bool operator==(const Truth&, const Truth&) = default;
};

/// Where a case comes from. Free text but for seed. Rows of tables and names of finds tell of it.
struct Origin {
  std::string contact;    ///< contact class, "FF" … or a further class
  std::string kind;       ///< "RP", "RN", …
  std::string generator;  ///< which construction
  std::optional<std::uint64_t> seed;
  std::optional<std::uint64_t> index;
  std::string ccdfuzz;  ///< version
  std::string name;     ///< if it is a named corpus entry
  std::string note;     ///< for readers
  /// Any further keys of the file, each with its string or number as JSON text; kept as they are.
  std::map<std::string, std::string> more;

  friend bool operator==(const Origin&, const Origin&) = default;
};

/// The proof word of a clearance.
inline std::string_view proof_word(const Clearance& clearance) {
  constexpr std::array<size_t, 6> kWords = {0, 1, 3, 4, 5, 6};
  return kProofWords[kWords[clearance.index()]];
}

/// The certificate of this kind by which nothing touches until its time, or null.
template <class Kind>
const Kind* clearance_of(const Truth& truth) {
  return truth.clearance ? std::get_if<Kind>(&*truth.clearance) : nullptr;
}

/// What a method must show on a case.
struct Expected {
  Outcome outcome = Outcome::kUnknown;
  /// An error's name ("hang"), what lost a contact ("left root"), of bodies their kind; or empty.
  std::string cause;

  Expected() = default;
  Expected(Outcome expected, std::string why = "") : outcome(expected), cause(std::move(why)) {}
  friend bool operator==(const Expected&, const Expected&) = default;
};

/// How methods are asked about a case; the defaults are those of SearchOptions.
struct Asked {
  double precision = 1e-4;             ///< in [2^-50, 1]
  std::uint64_t max_pops = 1'000'000;  ///< at least 1

  /// Whether methods can be asked at this precision: 2^-50 is where Cell::kMaxDepth ends.
  static bool admits(double precision);

  friend bool operator==(const Asked&, const Asked&) = default;
};

/// A query with its truth.
struct Case {
  Query query;
  Truth truth;
  Origin origin;
  Asked asked = {};
  std::map<std::string, Expected> expect = {};  ///< method spec → what replay must find

  friend bool operator==(const Case&, const Case&) = default;
};

}  // namespace ccdfuzz
