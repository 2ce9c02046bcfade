#include "finds/shrink.hpp"

#include <gtest/gtest.h>

#include "certify/checker/check_case.hpp"
#include "certify/oracle/feature_depth.hpp"
#include "generators/generate.hpp"

namespace ccdfuzz {
namespace {

class MissesAll : public Method {
 public:
  Answered answer(const Query&, const SearchOptions&) override {
    Answered miss;
    miss.verdict = Verdict::kMiss;
    return miss;
  }
};

Asker asker_of_misses() {
  return Asker({}, MethodSet([](const std::string&) -> Result<std::unique_ptr<Method>> {
                 return std::make_unique<MissesAll>();
               }));
}

double largest(const Query& query) {
  double most = 0;
  for (const MovingPatch<double>& patch : query.patches) {
    for (const Vec3<double>& p : patch.positions) most = std::max(most, p.cwiseAbs().maxCoeff());
  }
  return most;
}

TEST(Shrink, ADeepMissStaysDeep) {
  GeneratorOptions options;
  options.contact = ContactClass::kVF;
  options.construction = Construction::kOneSided;
  options.shapes = {Shape::point(), Shape::triangle(1)};
  Asker asker = asker_of_misses();
  int deep_ones = 0;
  for (std::uint64_t index = 0; index < 6; ++index) {
    Case found = generate(options, index).value;
    found.query.t_max *= 1.5;
    const Failure failure = asker.failure("tdibm", found).value();
    const double deep = feature_depth(found, found.query.t_max) / largest(found.query);
    const Case small = shrink(found, failure, asker).value;
    const double left = feature_depth(small, small.query.t_max) / largest(small.query);
    deep_ones += deep > 0 ? 1 : 0;
    EXPECT_GE(left, deep / 2);
    EXPECT_LT(size_of(small.query), size_of(found.query));
    EXPECT_EQ(asker.depth("tdibm", checked_or_unknown(small)),
              feature_depth(small, small.query.t_max));
  }
  EXPECT_GE(deep_ones, 3);
}

}  // namespace
}  // namespace ccdfuzz
