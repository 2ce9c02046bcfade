#pragma once

#include <optional>

#include "case/query.hpp"
#include "method/features.hpp"

namespace ccdfuzz {

/// Makes of a query one that a method takes: with velocities, where it does not take ends, and
/// without weights, where it does not take those. A separation that is kept (is_kept) is left out:
/// the answer is judged by the truth of the query with it. Where the query is taken as it is, or is
/// not valid, it is not copied.
class TakenQuery {
 public:
  TakenQuery(const Query& query, const Features& features);

  /// nullptr: not taken, and why() says why.
  const Query* query() const { return query_; }
  const char* why() const { return why_; }

 private:
  std::optional<Query> converted_;
  const Query* query_;
  const char* why_ = "";
};

}  // namespace ccdfuzz
