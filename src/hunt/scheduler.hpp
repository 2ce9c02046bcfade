#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace ccdfuzz {

/// Shares CPU time equally among cells, whatever one turn of each costs: the next turn always goes
/// to the cell that has used least. A slow cell gets few turns and starves nobody.
///
/// Turns may overlap: a cell whose turn still runs is charged with what its last turn cost, so
/// that several threads do not all pick the same one. Ties go to the cell with the fewest turns so
/// far, and then to the first. Not synchronised: the caller locks.
class Scheduler {
 public:
  explicit Scheduler(size_t cells) : cells_(cells) {}

  /// The cell whose turn it is; every begin is followed by one end.
  /// Requires at least one cell.
  size_t begin();
  /// The turn of `cell` is over and cost that much CPU time.
  void end(size_t cell, double seconds);

  double used(size_t cell) const { return cells_[cell].used; }

 private:
  struct Cell {
    double used = 0;
    double last = 0;  ///< what its last turn cost
    std::uint64_t running = 0;
    std::uint64_t begun = 0;
  };

  std::vector<Cell> cells_;
};

}  // namespace ccdfuzz
