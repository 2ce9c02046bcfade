#include "certify/checker/spin.hpp"

#include "numeric/exact_scalars.hpp"

namespace ccdfuzz {

std::array<Rational, 4> quaternion_of_spin(const std::vector<double>& spin, const Rational& t,
                                           Work& work) {
  constexpr unsigned long kUnitBits = 160, kTerms = 32;
  constexpr std::uint64_t kWorkOfATerm = 256;  // products and quotients of up to nine words
  work.charge(kTerms * kWorkOfATerm);
  std::array<Integer, 3> u;
  Integer x = 0;  // in squares of the unit
  for (size_t i = 0; i < 3; ++i) {
    const Rational w = exact(spin[i]);
    work.charge(product_work(w, t));
    const Rational half = w * t / 2;
    u[i] = (half.get_num() << kUnitBits) / half.get_den();
    x += u[i] * u[i];
  }
  Integer cosine = 0, sine = 0, term = Integer(1) << kUnitBits;
  for (unsigned long k = 0; k < kTerms; ++k) {
    cosine += term;
    sine += term / (2 * k + 1);
    term = -(term * x) / (Integer((2 * k + 1) * (2 * k + 2)) << (2 * kUnitBits));
  }
  std::array<Rational, 4> out{Rational(cosine, Integer(1) << kUnitBits)};
  for (size_t i = 0; i < 3; ++i) {
    out[i + 1] = Rational(Integer(sine * u[i]), Integer(1) << (2 * kUnitBits));
  }
  for (Rational& q : out) q.canonicalize();
  return out;
}

}  // namespace ccdfuzz
