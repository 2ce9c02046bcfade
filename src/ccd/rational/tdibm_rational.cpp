#include "ccd/rational/tdibm_rational.hpp"

#include "ccd/rational/pair_test.hpp"

namespace ccdfuzz {

TdibmRational::TdibmRational() : test_(std::make_unique<exact_ccd::PairTest>()) {}
TdibmRational::~TdibmRational() = default;
TdibmRational::TdibmRational(TdibmRational&&) noexcept = default;
TdibmRational& TdibmRational::operator=(TdibmRational&&) noexcept = default;

Answer TdibmRational::answer(const Query& query, const SearchOptions& options) {
  return search_.run(query, options, *test_);
}

const exact_ccd::TierCounts& TdibmRational::tiers() const {
  return test_->gap().counts();
}

}  // namespace ccdfuzz
