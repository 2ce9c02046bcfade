#include "fuzz/mutating.hpp"

#include <algorithm>

#include "fuzz/mutator/case_bytes.hpp"
#include "fuzz/mutator/mutate.hpp"

// libFuzzer's; other engines and replaying have none.
extern "C" __attribute__((weak)) std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size,
                                                              std::size_t max_size);

namespace ccdfuzz {

namespace {

std::size_t put(const WitnessedQuery& q, std::span<std::uint8_t> out) {
  const auto bytes = to_bytes(q);
  if (!bytes || bytes->size() > out.size()) return 0;
  std::copy(bytes->begin(), bytes->end(), out.begin());
  return bytes->size();
}

/// What an empty corpus begins with: a point that falls on a line.
WitnessedQuery first_query() {
  WitnessedQuery q;
  q.query.patches[0] = {Shape::point(), {{0, 0, 1}}, {{0, 0, -1}}};
  q.query.patches[1] = {Shape::curve(1), {{-1, 0, 0}, {1, 0, 0}}, {{0, 0, 0}, {0, 0, 0}}};
  q.t = Dyadic(1);
  q.uv[1][0] = Dyadic(Integer(1), -1);
  return q;
}

}  // namespace

std::size_t mutate_case(std::uint8_t* data, std::size_t size, std::size_t max_size, unsigned seed,
                        std::uint64_t every) {
  Random random(seed);
  if (random.below(every) == 0 && LLVMFuzzerMutate != nullptr) {
    return LLVMFuzzerMutate(data, size, max_size);
  }
  const WitnessedQuery q = witnessed_query_of(std::span(data, size)).value_or(first_query());
  return put(mutate(q, q, random), {data, max_size});
}

std::size_t cross_cases(std::span<const std::uint8_t> a, std::span<const std::uint8_t> b,
                        std::span<std::uint8_t> out, unsigned seed) {
  Random random(seed);
  const auto mother = witnessed_query_of(a), father = witnessed_query_of(b);
  return mother && father ? put(mutate(*mother, *father, random), out) : 0;
}

}  // namespace ccdfuzz
