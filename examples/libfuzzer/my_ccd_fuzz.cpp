// A CCD code fuzzed by libFuzzer on contacts that are there. It has a fault.
#include <Eigen/Geometry>
#include <ccdfuzz/files/case_json.hpp>
#include <ccdfuzz/mutate.hpp>
#include <iostream>

/// The fault: it looks at the end of the step alone.
static ccdfuzz::Answer my_ccd(const ccdfuzz::Query& query) {
  std::array<Eigen::AlignedBox3d, 2> boxes;
  for (std::size_t s = 0; s < 2; ++s) {
    for (const Eigen::Vector3d& p : query.patches[s].at(query.t_max)) boxes[s].extend(p);
  }
  return boxes[0].intersects(boxes[1]) ? ccdfuzz::Answer::hit(0) : ccdfuzz::Answer::miss();
}

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  const auto contact = ccdfuzz::contact_of_bytes({data, size});
  if (!contact) return -1;  // not for the corpus
  const auto missed = ccdfuzz::is_false_negative(*contact, my_ccd(contact->query));
  if (!missed) return 0;
  std::cerr << missed << '\n' << to_json(case_of(*contact)) << '\n';
  std::abort();
}
extern "C" size_t LLVMFuzzerCustomMutator(uint8_t* data, size_t size, size_t max, unsigned seed) {
  return ccdfuzz::mutate_case(data, size, max, seed);
}
