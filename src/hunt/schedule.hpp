#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace ccdfuzz {

/// A step of a hunt.
struct Turn {
  enum class What : std::uint8_t {
    kDraw,   ///< ask the cell's method about a draw
    kBreed,  ///< go on with the cell's population; no two threads do so for one cell
  };
  std::size_t cell = 0;
  What what = What::kDraw;
  std::uint64_t draw = 0;  ///< its index; of a breeding turn, how many the cell has begun
};

/// Whose turn it is, and for what. Not synchronised: the caller locks.
///
/// By time it shares CPU time equally among cells, whatever one turn of each costs. The next turn
/// goes to the cell that has used least; among equals to the one with the fewest turns, and then to
/// the last. So a slow cell gets few turns and starves nobody. A cell breeds while that has taken
/// less time than its draws. Turns may overlap. A cell whose turn still runs is charged with what
/// its last turn cost, so that several threads do not all pick the same one. By draws it gives
/// every draw of each cell, and then one breeding turn of each.
class Schedule {
 public:
  /// By time, without end; or by this many draws of each cell. Requires a cell.
  explicit Schedule(std::size_t cells, std::optional<std::uint64_t> draws = std::nullopt);

  /// Every turn is followed by one done. Nothing once all draws and breeding turns were given.
  std::optional<Turn> next();
  /// The turn is over and cost this much CPU time. bred: false of a breeding turn that had nothing
  /// to make mutants of.
  void done(const Turn& turn, double seconds, bool bred = true);

  double used(std::size_t cell) const { return cells_[cell].drawn + cells_[cell].bred; }
  std::uint64_t draws_done(std::size_t cell) const { return cells_[cell].draws_done; }
  /// By draws: how much of all is done, in [0, 1]; half of it is breeding.
  double share_done() const;

 private:
  struct Cell {
    double drawn = 0, bred = 0;  ///< seconds of turns that are over
    double last = 0;             ///< what its last turn cost
    std::uint64_t running = 0, turns = 0;
    std::uint64_t draws = 0, draws_done = 0;  ///< begun; over
    bool breeds = false;                      ///< now
  };

  Turn next_by_time();

  std::vector<Cell> cells_;
  std::optional<std::uint64_t> draws_;
  std::uint64_t given_ = 0, draws_done_ = 0, breeding_done_ = 0;
};

}  // namespace ccdfuzz
