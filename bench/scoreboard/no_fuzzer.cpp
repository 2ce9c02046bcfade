// In place of fuzz_drivers.cpp where the compiler has no libFuzzer.
#include <cstdlib>

#include "fuzz_drivers.hpp"

namespace ccdfuzz {

void drive_fuzzer(Driver, std::uint64_t, const DriveLimit&,
                  const std::function<void(const DriverRun&)>&) {
  std::abort();
}

}  // namespace ccdfuzz
