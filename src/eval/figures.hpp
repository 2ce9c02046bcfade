#pragma once

#include <string>
#include <vector>

#include "eval/groups.hpp"
#include "eval/shard.hpp"
#include "query/case_files.hpp"

namespace ccdfuzz {

/// The data behind the paper's figures, as CSV with a header.

/// Fig. 5: curvature at the contact, a line for each patch of each case that has a witness and is
/// in the share: `index` of the case, principal curvatures and their root mean square.
std::string figure_5_header();
std::string figure_5_lines(const std::vector<NamedCase>& cases, const Shard& shard);

/// Fig. 8: rate of false negatives and mean time of each method on each class, all kinds as one,
/// asked up to the contact.
std::string figure_8_csv(const std::vector<EvaluatedGroup>& groups);

/// Fig. 9: how the running times of each method on each class are distributed: 50 equal bins from 0
/// to the longest ("linear"), and ten a decade ("log"). Empty bins are left out.
std::string figure_9_csv(const std::vector<EvaluatedGroup>& groups);

}  // namespace ccdfuzz
