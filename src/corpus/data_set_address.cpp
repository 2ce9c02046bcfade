#include "corpus/data_set_address.hpp"

#include <fmt/format.h>
#include <xxhash.h>

#include "corpus/content_address.hpp"

namespace ccdfuzz {

std::string data_set_address(const std::vector<NamedCase>& cases) {
  std::string text;
  for (const NamedCase& named : cases) {
    const std::optional<bool>& collides = named.value.truth.collides;
    text += content_address(named.value.query) + (!collides ? '?' : *collides ? '+' : '-');
  }
  const XXH128_hash_t hash = XXH3_128bits(text.data(), text.size());
  return fmt::format("{:016x}{:016x}", hash.high64, hash.low64);
}

}  // namespace ccdfuzz
