#include "fuzz/mutator/mutate.hpp"

#include "fuzz/mutator/moves.hpp"

namespace ccdfuzz {

namespace {

/// A move that looks at nothing but the query.
template <bool (*move)(Contact&, Draw&)>
bool alone(Contact& q, const Contact&, Draw& draw) {
  return move(q, draw);
}

constexpr std::array kMoves = {
    Move{"shift-in-null-space", alone<shift_in_null_space>},
    Move{"trade-position-for-velocity", alone<trade_position_for_velocity>},
    Move{"nudge", alone<nudge>},
    Move{"make-twins", alone<make_twins>},
    Move{"align-edge", alone<align_edge>},
    Move{"flatten", alone<flatten>},
    Move{"collapse", alone<collapse>},
    Move{"snap-to-lattice", alone<snap_to_lattice>},
    Move{"stop-motion", alone<stop_motion>},
    Move{"stretch", alone<stretch>},
    Move{"change-coordinates", alone<change_coordinates>},
    Move{"reparametrise", alone<reparametrise>},
    Move{"elevate-degree", alone<elevate_degree>},
    Move{"restrict-to-child", alone<restrict_to_child>},
    Move{"splice", splice},
    Move{"change-horizon", alone<change_horizon>},
    Move{"give-ends", alone<give_ends>},
    Move{"give-separation", alone<give_separation>},
    Move{"give-weights", alone<give_weights>},
    Move{"change-trim", alone<change_trim>},
};

/// The last moves make queries that are not plain.
constexpr std::size_t kNotPlain = 4;

}  // namespace

std::span<const Move> moves() {
  return kMoves;
}

Contact mutate(const Contact& q, const Contact& other, Draw& draw, QueryRange range) {
  constexpr std::size_t kMost = 4;
  // Where a single move is possible, this many draws have it kMost times in the mean.
  constexpr std::size_t kTries = kMost * kMoves.size();
  const std::size_t moves = range == QueryRange::kAll ? kMoves.size() : kMoves.size() - kNotPlain;
  Contact mutant = q, next = q;
  std::uint64_t wanted = 1 + draw.below(kMost);
  for (std::size_t i = 0; i < kTries && wanted > 0; ++i) {
    if (kMoves[draw.below(moves)].apply(next, other, draw)) {
      mutant = next;
      --wanted;
    } else {
      next = mutant;
    }
  }
  return mutant;
}

}  // namespace ccdfuzz
