#include "fault_hash.hpp"

#include <fmt/format.h>
#include <xxhash.h>

namespace ccdfuzz {

namespace {

std::string hash_of(const std::string& text) {
  return fmt::format("{:08x}", XXH3_64bits(text.data(), text.size()) >> 32);
}

}  // namespace

std::string definition_hash(const PlantedFault& fault) {
  return hash_of(fmt::format("{}\n{}\n{}\n{}", fault.file, fault.statement ? "stmt" : "expr",
                             fault.from, fault.to));
}

std::string definition_hash(const std::vector<PlantedFault>& faults) {
  std::string all;
  for (const PlantedFault& fault : faults) all += definition_hash(fault) + " " + fault.name + "\n";
  return hash_of(all);
}

}  // namespace ccdfuzz
