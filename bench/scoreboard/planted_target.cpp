// What makes a fuzz target one with a fault in it. The environment variable CCDFUZZ_FAULT names the
// fault of faults.txt that is active in this process. Without it there is none.
#include <cstdlib>
#include <iostream>

#include "fault_list.hpp"
#include "planted.hpp"

extern "C" int LLVMFuzzerInitialize(int* /*argc*/, char*** /*argv*/) {
  using namespace ccdfuzz;  // NOLINT: of this function alone
  const char* wanted = std::getenv("CCDFUZZ_FAULT");
  if (wanted == nullptr || *wanted == 0) return 0;
  const auto faults = read_faults(CCDFUZZ_FAULTS);
  for (std::size_t f = 0; faults && f < faults->size(); ++f) {
    if ((*faults)[f].name == wanted) planted::active_fault = static_cast<int>(f + 1);
  }
  if (planted::active_fault != planted::kNone) return 0;
  std::cerr << "CCDFUZZ_FAULT: no fault \"" << wanted << "\"\n";
  std::exit(2);
}
