// How libFuzzer crosses the inputs of targets on case bytes: a case with parts of another.
#include "fuzz/mutator/mutate.hpp"

extern "C" std::size_t LLVMFuzzerCustomCrossOver(const std::uint8_t* data1, std::size_t size1,
                                                 const std::uint8_t* data2, std::size_t size2,
                                                 std::uint8_t* out, std::size_t max_size,
                                                 unsigned int seed) {
  return ccdfuzz::cross_cases({data1, size1}, {data2, size2}, out, max_size, seed,
                              ccdfuzz::QueryRange::kAll);
}
