#pragma once

#include <atomic>

#include "hunt/hunt.hpp"
#include "scratch_folder.hpp"

namespace ccdfuzz {

/// A hunt into a folder of its own, when it is over.
struct Hunted {
  explicit Hunted(const HuntOptions& options) {
    const std::atomic<bool> stop = false;
    report = hunt(
        options, store, [](const HuntProgress&) {}, stop);
  }

  ScratchFolder folder;
  Store store = Store::open(folder.path()).value();
  HuntReport report;
};

/// What all cells asked.
struct AskedInAll {
  std::uint64_t queries = 0, mutants = 0;
};

inline AskedInAll asked_of(const HuntReport& report) {
  AskedInAll asked;
  for (const HuntCell& cell : report.cells) {
    asked.queries += cell.tally.n;
    asked.mutants += cell.bred.mutants;
  }
  return asked;
}

}  // namespace ccdfuzz
