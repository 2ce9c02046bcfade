#pragma once

#include <string>
#include <vector>

#include "hunt/hunt.hpp"
#include "report/report.hpp"

namespace ccdfuzz {

/// Notes how far a hunt is, at most so often that a page has room for it.
class HuntSamples {
 public:
  void note(double seconds, std::uint64_t queries, std::uint64_t finds);
  const std::vector<HuntSample>& all() const { return samples_; }

 private:
  std::vector<HuntSample> samples_;
  double next_ = 0, step_ = 0.25;  ///< seconds
};

/// What a hunt's page shows: its cells, its course, what it found, and what its store (a folder)
/// held before. Errors: the store cannot be read.
Result<ReportPage> hunt_page(const HuntReport& hunted, const std::string& store,
                             const std::vector<HuntSample>& samples);

}  // namespace ccdfuzz
