#include "ccd/certified/pair_split.hpp"

namespace ccdfuzz::certified {

void PairSplit::begin(const Query& query, int finest) {
  finest_ = finest;
  normalise(query, query_);
  for (int s = 0; s < 2; ++s) trees_[s].reset(query_.shapes[s], query_.controls[s]);
}

}  // namespace ccdfuzz::certified
