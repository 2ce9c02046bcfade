#pragma once

#include <cstdint>
#include <vector>

#include "query/case.hpp"
#include "query/taxonomy.hpp"

namespace ccdfuzz {

/// The endless sequence of cases that `ccdfuzz trace --generate` traces, each with an exact
/// witness. They come in blocks: one construction and what becomes of it in other coordinates, all
/// exact: scaled by 2^-1000 to 2^900, with a common velocity and moved by up to 2^40 of its size,
/// where its numbers have the bits for it, in other units of time, asked past its contact. Blocks
/// go round the contact classes and within them round the one-sided construction, the stress
/// families and planted contacts. Case n is in block n / kTracedBlock.
inline constexpr std::uint64_t kTracedBlock = 16;

struct TracedBlock {
  ContactClass contact = ContactClass::kFF;
  std::vector<Case> cases;  ///< kTracedBlock of them
};

/// Depends on the arguments alone.
TracedBlock traced_block(std::uint64_t seed, std::uint64_t block);

}  // namespace ccdfuzz
