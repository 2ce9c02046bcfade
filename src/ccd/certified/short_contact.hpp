#pragma once

#include <optional>

#include "case/query.hpp"

namespace ccdfuzz::certified {

/// What short integers tell of a linear query.
struct ShortAnswer {
  bool touch;        ///< the patches touch at some t in [0, t_max]
  double share = 0;  ///< touching: as LinearContact::toi, of t_max and not yet rounded down
};

/// Parts of the time step that short integers look at, as a power of two.
inline constexpr int kShortLevel = 44;

/// Decides most linear queries in integers of fixed length, and by signs that are clear in doubles
/// of these (DERIVATION.md, 7, L10). The first contact is a root of the determinant (Law L2). Signs
/// of coefficients part the roots (Law L3), and at each Law L1 decides. Law L10: no integer is too
/// long, and a double beyond twice its error has the integer's sign. Returns nothing where numbers
/// have more than 124 binary places. The same where the determinant is 0 throughout or its roots
/// are too near each other, and where a sign stays 0 or unknown. Requires finite numbers, t_max ≥
/// 0, is_linear_pair and FpGuard::holds().
std::optional<ShortAnswer> short_contact(const Query& query);

}  // namespace ccdfuzz::certified
