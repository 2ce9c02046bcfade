#include "hunt/population.hpp"

#include <utility>

namespace ccdfuzz {

void Population::join(Contact q, const Standing& standing) {
  const auto [at, is_new] = places_.try_emplace(standing.niche, members_.size());
  if (is_new) {
    members_.push_back({std::move(q), standing.nearness});
  } else if (Member& old = members_[at->second]; standing.nearness <= old.nearness) {
    old = {std::move(q), standing.nearness};
  }
}

const Contact& Population::nearer_of_two(Draw& draw) const {
  const Member& a = members_[draw.below(members_.size())];
  const Member& b = members_[draw.below(members_.size())];
  return a.nearness <= b.nearness ? a.q : b.q;
}

}  // namespace ccdfuzz
