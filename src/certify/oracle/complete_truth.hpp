#pragma once

#include <string>

#include "certify/oracle/oracle.hpp"

namespace ccdfuzz {

/// A case with all of its truth that could be proven.
struct Completed {
  Case value;
  /// What the case claimed is false: its truth is replaced.
  bool refuted = false;
  std::string note;  ///< why it is undecided, or what was refuted
};

/// Decides the query of a case and completes its truth: contact or absence, and both certificates.
/// A witness or clearance of the case's own stays if it proves more. So does a claim of absence
/// that goes beyond what could be proven here. Where checking its clearance meets a limit, what the
/// case says of absence is left out. Requires that check_truth accepts the case.
Completed complete_truth(const Case& value, OracleOptions options = {});

}  // namespace ccdfuzz
