#include "fuzz/lost_inputs.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdlib>
#include <fstream>

namespace ccdfuzz {

LostInputs::LostInputs() {
  if (const char* folder = std::getenv("CCDFUZZ_LOST")) folder_ = folder;
}

void LostInputs::keep(std::span<const std::uint8_t> bytes, const std::string& kind) {
  constexpr std::size_t kMostKinds = 2000;
  if (folder_.empty() || kinds_.size() >= kMostKinds || !kinds_.insert(kind).second) return;
  // Unique among the processes that share the folder.
  std::ofstream out(fmt::format("{}/{}-{}", folder_, ::getpid(), kinds_.size()), std::ios::binary);
  out.write(reinterpret_cast<const char*>(bytes.data()),
            static_cast<std::streamsize>(bytes.size()));
}

}  // namespace ccdfuzz
