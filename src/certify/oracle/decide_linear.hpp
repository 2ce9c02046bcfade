#pragma once

#include "certify/oracle/oracle.hpp"

namespace ccdfuzz {

/// decide for linear queries (linear::is_linear), exactly: it is never undecided. A contact at a
/// rational time comes as a witness with clear_until at that very time; one at an irrational time
/// as a contact root, in an enclosure 2^-64 times the longest time looked at or narrower, which
/// also gives clear_until. Looks past t_max where options tell of a later time.
Decision decide_linear(const Query& query, const OracleOptions& options);

}  // namespace ccdfuzz
