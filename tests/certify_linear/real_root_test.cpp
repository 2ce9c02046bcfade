#include "certify/linear/real_root.hpp"

#include <gtest/gtest.h>

#include "rapidcheck.hpp"

namespace ccdfuzz::linear {
namespace {

Polynomial linear_factor(const Rational& root) {
  return Polynomial({-root.get_num(), root.get_den()});
}

Rational any_small_rational() {
  Rational x(*rc::gen::inRange(-12, 40), *rc::gen::inRange(1, 9));
  x.canonicalize();
  return x;
}

/// x² − 2, x² − 3: irrational roots, where the others are rational.
Polynomial square_minus(int n) {
  return Polynomial({Integer(-n), Integer(0), Integer(1)});
}

RC_GTEST_PROP(RealRoot, RootsOfAProductAreThoseOfItsFactors, ()) {
  std::vector<Rational> factors;
  Polynomial p({Integer(*rc::gen::element(1, -1, 7))});
  for (int i = *rc::gen::inRange(0, 4); i >= 0; --i) {
    factors.push_back(any_small_rational());
    const int multiplicity = *rc::gen::inRange(1, 4);
    for (int k = 0; k < multiplicity; ++k) p = p * linear_factor(factors.back());
  }
  if (*rc::gen::arbitrary<bool>()) p = p * square_minus(2) * square_minus(-1);
  Rational from = *rc::gen::element(Rational(0), Rational(1, 3), factors[0]);
  const Rational to = from + *rc::gen::element(Rational(0), Rational(1), Rational(3));
  std::vector<RealRoot> roots = roots_in(p, from, to);

  std::vector<Rational> expected;
  for (const Rational& x : factors) {
    if (from <= x && x <= to) expected.push_back(x);
  }
  std::sort(expected.begin(), expected.end());
  expected.erase(std::unique(expected.begin(), expected.end()), expected.end());
  size_t rational = 0;
  for (RealRoot& root : roots) {
    RC_ASSERT(from <= root.lo() && root.hi() <= to);
    if (root.sign_of(square_minus(2)) == 0) continue;
    RC_ASSERT(rational < expected.size());
    RC_ASSERT(root.sign_of(linear_factor(expected[rational])) == 0);
    RC_ASSERT(root.is_rational());
    RC_ASSERT(root.lo() == expected[rational]);
    ++rational;
  }
  RC_ASSERT(rational == expected.size());
  for (size_t i = 1; i < roots.size(); ++i) {
    RC_ASSERT((compare(roots[i - 1], roots[i]) == std::strong_ordering::less));
  }
}

TEST(RealRoot, KnowsSignsAtAnIrrationalNumber) {
  std::vector<RealRoot> roots = roots_in(square_minus(2) * square_minus(3), 0, 2);
  ASSERT_EQ(roots.size(), 2U);
  RealRoot &two = roots[0], &three = roots[1];
  EXPECT_EQ(two.sign_of(square_minus(2) * square_minus(5)), 0);
  EXPECT_EQ(two.polynomial(), square_minus(2)) << "the common divisor is what is left";
  EXPECT_EQ(two.sign_of(square_minus(3)), -1);
  // 1.41421356237309504880168872420969807856967187537694… between its 45th and 46th digit.
  const Polynomial near({-Integer("1414213562373095048801688724209698078569671875"),
                         Integer("1000000000000000000000000000000000000000000000")});
  EXPECT_EQ(two.sign_of(near), 1);
  EXPECT_EQ(three.sign_of(square_minus(2)), 1);
  EXPECT_EQ(two.sign_of(Polynomial()), 0);
  EXPECT_EQ(two.sign_of(Polynomial({Integer(-4)})), -1);
}

TEST(RealRoot, ComparesRootsOfDifferentPolynomials) {
  RealRoot a = roots_in(square_minus(2), 1, 2)[0];
  RealRoot b = roots_in(square_minus(2) * square_minus(3), 0, 2)[0];
  RealRoot rational(Rational(Integer("1414213562373095048801688724209698078569"),
                             Integer("1000000000000000000000000000000000000000")));
  EXPECT_TRUE(compare(a, b) == 0);
  EXPECT_TRUE(compare(rational, a) < 0);
  EXPECT_TRUE(compare(a, rational) > 0);
  EXPECT_TRUE(compare(rational, rational) == 0);
}

TEST(RealRoot, FindsThatARootIsRationalOnceNarrow) {
  // 3x − 1 times x² − 2, whose bisection never meets 1/3.
  RealRoot third = roots_in(Polynomial({Integer(-1), Integer(3)}) * square_minus(2), 0, 1)[0];
  third.narrow(Rational(1, 1000));
  ASSERT_TRUE(third.is_rational());
  EXPECT_EQ(third.lo(), Rational(1, 3));
  RealRoot root = roots_in(square_minus(2), 0, 2)[0];
  root.narrow(power_of_two(-80));
  EXPECT_FALSE(root.is_rational());
  EXPECT_LE(Rational(root.hi() - root.lo()), power_of_two(-80));
  EXPECT_LT(square_minus(2).sign_at(root.lo()), 0);
  EXPECT_GT(square_minus(2).sign_at(root.hi()), 0);
}

RC_GTEST_PROP(SimplestBetween, IsInsideAndNoneIsSimpler, ()) {
  const Rational x = abs(any_small_rational()), y = abs(any_small_rational());
  if (x == y) return;
  const Rational lo = std::min(x, y), hi = std::max(x, y);
  const Rational simplest = simplest_between(lo, hi);
  RC_ASSERT(lo < simplest && simplest < hi);
  for (int q = 1; Integer(q) < simplest.get_den(); ++q) {
    Integer p;
    mpz_fdiv_q(p.get_mpz_t(), Integer(lo.get_num() * q).get_mpz_t(), lo.get_den_mpz_t());
    RC_ASSERT(!(Rational(p + 1, q) < hi));  // p + 1 is the least above lo·q
  }
}

}  // namespace
}  // namespace ccdfuzz::linear
