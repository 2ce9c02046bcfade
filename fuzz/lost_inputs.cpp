#include "fuzz/lost_inputs.hpp"

#include <cstdlib>
#include <string_view>
#include <tuple>

#include "io/hash_name.hpp"
#include "io/output_file.hpp"

namespace ccdfuzz {

LostInputs::LostInputs() {
  if (const char* folder = std::getenv("CCDFUZZ_LOST")) folder_ = folder;
}

void LostInputs::keep(std::span<const std::uint8_t> bytes, const std::string& kind) {
  // Methods have some hundred kinds each; what comes after many more is noise that fills a disk.
  constexpr std::size_t kMostKinds = 2000;
  if (folder_.empty() || kinds_.size() >= kMostKinds || !kinds_.insert(kind).second) return;
  // By its content: no process, of whatever session, overwrites what another left to triage.
  // Complete or absent. Where it cannot be written, as on a full disk, the session continues
  // without it.
  const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  std::ignore = write_file(folder_ + "/" + hash_name(text), text);
}

}  // namespace ccdfuzz
