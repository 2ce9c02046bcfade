#pragma once

#include <string>
#include <vector>

namespace ccdfuzz {

class Session;

/// Adds the entries of corpora to the corpus `output`: of each failure the smallest stays, as if
/// one hunt had found them all.
int merge_corpora(const std::vector<std::string>& inputs, const std::string& output,
                  Session& session);

}  // namespace ccdfuzz
