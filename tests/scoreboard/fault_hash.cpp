#include "fault_hash.hpp"

#include <fmt/format.h>
#include <xxhash.h>

namespace ccdfuzz {

std::string definition_hash(const Fault& fault) {
  const std::string text = fmt::format("{}\n{}\n{}\n{}", fault.file,
                                       fault.statement ? "stmt" : "expr", fault.from, fault.to);
  return fmt::format("{:08x}", XXH3_64bits(text.data(), text.size()) >> 32);
}

}  // namespace ccdfuzz
