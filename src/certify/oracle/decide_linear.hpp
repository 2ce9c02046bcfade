#pragma once

#include "certify/oracle/oracle.hpp"

namespace ccdfuzz {

/// decide for linear queries (linear::is_linear), exactly: it is never undecided. A contact at a
/// rational time comes as a witness, with clear_until at that very time. One at an irrational time
/// comes as a contact root, whose enclosure also gives clear_until. It is at most 2^-64 times as
/// wide as the longest time looked at. Looks past t_max where options tell of a later time.
Decision decide_linear(const Query& query, const OracleOptions& options);

}  // namespace ccdfuzz
