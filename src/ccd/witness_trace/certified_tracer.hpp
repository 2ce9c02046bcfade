#pragma once

#include "ccd/certified/pair_split.hpp"
#include "ccd/certified/tdibm_c.hpp"
#include "ccd/witness_trace/frontier.hpp"
#include "ccd/witness_trace/watch.hpp"

namespace ccdfuzz {

/// Follows a witness through the splits of tdibm-c. That method does not test the whole patches, so
/// the first level is 1. It does not split linear patches (is_linear_pair). The one pair, of level
/// 0, then shows which axes it advances along, and what its answer leaves of the time step. Margins
/// and gaps are in its own time scale, t* and t_max divided by a power of two. Places and
/// exclusions are in that of the query.
class CertifiedTracer {
 public:
  /// As InclusionTracer::trace.
  const Trace& trace(const Query& query, const Witness& witness, const TraceOptions& options);

 private:
  void split(const certified::CellPair& pair, const TraceOptions& options);
  void follow_linear(const Query& query, const TraceOptions& options);

  certified::PairSplit split_;
  TdibmC linear_;
  WitnessPath path_;
  WitnessWatch watch_;
  std::vector<certified::CellPair> now_, next_;
};

}  // namespace ccdfuzz
