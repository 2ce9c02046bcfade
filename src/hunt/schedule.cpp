#include "hunt/schedule.hpp"

#include <algorithm>
#include <ranges>

#include "base/verify.hpp"

namespace ccdfuzz {

Schedule::Schedule(std::size_t cells, std::optional<std::uint64_t> draws)
    : cells_(cells), draws_(draws) {
  CCDFUZZ_VERIFY(!cells_.empty());
}

std::optional<Turn> Schedule::next() {
  if (!draws_) return next_by_time();
  const std::uint64_t draws = *draws_ * cells_.size();
  if (given_ == draws + cells_.size()) return std::nullopt;
  const std::uint64_t place = given_++;
  if (place >= draws) return Turn{place - draws, Turn::What::kBreed, *draws_};
  Turn turn{place % cells_.size(), Turn::What::kDraw, place / cells_.size()};
  ++cells_[turn.cell].draws;
  return turn;
}

Turn Schedule::next_by_time() {
  const auto expected = [](const Cell& c) {
    return c.drawn + c.bred + c.last * static_cast<double>(c.running);
  };
  // The last cells come first. The cost of a first turn is unknown, and a coarse clock may see none
  // at all.
  auto backwards = cells_ | std::views::reverse;
  const auto next = std::ranges::min_element(backwards, [&](const Cell& a, const Cell& b) {
    return expected(a) != expected(b) ? expected(a) < expected(b) : a.turns < b.turns;
  });
  Cell& cell = *next;
  ++cell.running;
  ++cell.turns;
  Turn turn{static_cast<std::size_t>(&cell - cells_.data()), Turn::What::kDraw, cell.draws};
  if (!cell.breeds && cell.bred < cell.drawn) {
    turn.what = Turn::What::kBreed;
    cell.breeds = true;
  } else {
    ++cell.draws;
  }
  return turn;
}

void Schedule::done(const Turn& turn, double seconds, bool bred) {
  Cell& cell = cells_[turn.cell];
  CCDFUZZ_VERIFY(seconds >= 0);
  cell.last = seconds;
  if (!draws_) --cell.running;
  if (turn.what == Turn::What::kDraw) {
    ++draws_done_;
    ++cell.draws_done;
    cell.drawn += seconds;
    return;
  }
  ++breeding_done_;
  cell.breeds = false;
  // A cell without a population makes further draws first.
  cell.bred = bred ? cell.bred + seconds : std::max(cell.drawn, cell.bred);
}

double Schedule::share_done() const {
  if (!draws_) return 0;
  const auto cells = static_cast<double>(cells_.size());
  const double drawn = static_cast<double>(draws_done_) / (cells * static_cast<double>(*draws_));
  return (drawn + static_cast<double>(breeding_done_) / cells) / 2;
}

}  // namespace ccdfuzz
