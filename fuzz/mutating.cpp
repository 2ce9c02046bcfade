#include "fuzz/mutating.hpp"

#include <algorithm>

#include "fuzz/libfuzzer.hpp"
#include "fuzz/mutator/case_bytes.hpp"
#include "fuzz/mutator/exact_moves.hpp"
#include "fuzz/mutator/mutate.hpp"

namespace ccdfuzz {

namespace {

std::size_t put(const Contact& q, std::span<std::uint8_t> out) {
  const auto bytes = to_bytes(q);
  if (!bytes || bytes->size() > out.size()) return 0;
  std::copy(bytes->begin(), bytes->end(), out.begin());
  return bytes->size();
}

}  // namespace

std::size_t mutate_case(std::uint8_t* data, std::size_t size, std::size_t max_size, unsigned seed,
                        std::uint64_t every) {
  Draw draw{Random(seed)};
  if (draw.below(every) == 0 && LLVMFuzzerMutate != nullptr) {
    return LLVMFuzzerMutate(data, size, max_size);
  }
  const Contact q = contact_of_bytes(std::span(data, size)).value_or(falling_point());
  return put(mutate(q, q, draw), {data, max_size});
}

}  // namespace ccdfuzz

extern "C" std::size_t LLVMFuzzerCustomCrossOver(const std::uint8_t* data1, std::size_t size1,
                                                 const std::uint8_t* data2, std::size_t size2,
                                                 std::uint8_t* out, std::size_t max_size,
                                                 unsigned int seed) {
  using namespace ccdfuzz;  // NOLINT: of this function alone
  Draw draw{Random(seed)};
  const auto mother = contact_of_bytes(std::span(data1, size1));
  const auto father = contact_of_bytes(std::span(data2, size2));
  if (!mother || !father) return 0;
  Contact child = *mother;
  if (!splice(child, *father, draw)) return 0;
  return put(mutate(child, *father, draw), {out, max_size});
}
