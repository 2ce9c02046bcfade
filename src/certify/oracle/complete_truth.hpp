#pragma once

#include <string>

#include "certify/oracle/oracle.hpp"

namespace ccdfuzz {

/// A case with all of its truth that could be proven.
struct Completed {
  Case value;
  /// The tree of value.truth.clearance, if that is a tree; its place in a file is still the old
  /// one.
  std::string tree;
  /// What the case claimed is false: its truth is replaced.
  bool refuted = false;
  std::string note;  ///< why it is undecided, or what was refuted
};

/// Decides the query of a case and completes its truth: contact or absence, and both certificates.
/// A witness or clearance of the case's own stays if it proves more. So does a claim of absence
/// that goes beyond what could be proven here. tree: the bytes of its own tree, if its clearance is
/// one. An error in their place refutes it. Where it is a limit (is_limit), or checking meets one,
/// what the case says of absence is left out. Requires that check_truth accepts the case.
Completed complete_truth(const Case& value, const Result<std::string>& tree,
                         OracleOptions options = {});

}  // namespace ccdfuzz
