#include "hunt/traced_cases.hpp"

#include <cmath>

#include "eval/horizons.hpp"
#include "generators/generate.hpp"
#include "generators/planted.hpp"
#include "generators/similar.hpp"

namespace ccdfuzz {

namespace {

/// Not kScaled: all are scaled here.
constexpr std::array kTracedFamilies = {Family::kRegular, Family::kFlatGrazing,
                                        Family::kCommonVelocity, Family::kTwins,
                                        Family::kInteriorTime};

Case construction(ContactClass contact, std::uint64_t seed, std::uint64_t round, Random& random) {
  const std::uint64_t ground = round % (kTracedFamilies.size() + 1);
  if (ground == kTracedFamilies.size()) return planted_case(contact, random);
  GeneratorOptions options;
  options.contact = contact;
  options.construction = Construction::kOneSided;
  options.family = kTracedFamilies[ground];
  options.seed = seed;
  return generate(options, round / (kTracedFamilies.size() + 1)).value;
}

/// The exponent e of the patches' size, 2^(e-1) to 2^e; 0 if both are one point.
int size_exponent(const Query& query) {
  double size = 0;
  const Vec3<double>& first = query.patches[0].positions[0];
  for (const MovingPatch<double>& patch : query.patches) {
    for (const Vec3<double>& p : patch.positions) {
      for (int k = 0; k < 3; ++k) size = std::max(size, std::abs(p[k] - first[k]));
    }
  }
  int exponent = 0;
  std::frexp(size, &exponent);
  return exponent;
}

/// Three components of 4 bits each, up to 2^exponent.
Vec3<double> short_vector(int exponent, Random& random) {
  Vec3<double> v;
  for (int k = 0; k < 3; ++k) {
    v[k] = std::ldexp(static_cast<double>(random.between(-15, 15)), exponent - 4);
  }
  return v;
}

/// The case with something of `by` up to 2^40 of its size, or of as much as its bits allow.
template <class Change>
Case moved(const Case& base, int size, Random& random, const Change& by) {
  constexpr int kFarthest = 40, kStep = 5;
  for (int e = static_cast<int>(random.between(0, kFarthest)); e >= 0; e -= kStep) {
    if (auto out = similar(base, by(short_vector(size + e, random)))) return *std::move(out);
  }
  return base;
}

/// The case in random units. Subnormals have no room for all its bits: then it stays as it is.
Case rescaled(const Case& base, Random& random) {
  Similarity change;
  change.space = static_cast<int>(random.between(-1000, 900));
  if (random.below(4) == 0) change.time = static_cast<int>(random.between(-100, 100));
  auto out = similar(base, change);
  return out ? *std::move(out) : base;
}

Case variant(const Case& base, int size, Random& random) {
  Case out = base;
  if (random.coin()) {
    out = moved(out, size, random, [](const Vec3<double>& v) { return Similarity{.shift = v}; });
  }
  if (random.coin()) {
    out = moved(out, size, random, [](const Vec3<double>& v) { return Similarity{.drift = v}; });
  }
  if (random.below(4) != 0) out = rescaled(out, random);
  if (random.coin()) {
    if (auto later = at_horizon(out, random.pick(kHorizonFactors))) out = *std::move(later);
  }
  return out;
}

}  // namespace

TracedBlock traced_block(std::uint64_t seed, std::uint64_t block) {
  TracedBlock out;
  out.contact = kContactClasses[block % kContactClasses.size()];
  Random random = Random::keyed({seed, block, 0x7472616365});  // a stream of its own: "trace"
  const Case base = construction(out.contact, seed, block / kContactClasses.size(), random);
  const int size = size_exponent(base.query);
  out.cases.push_back(base);
  while (out.cases.size() < kTracedBlock) out.cases.push_back(variant(base, size, random));
  return out;
}

}  // namespace ccdfuzz
