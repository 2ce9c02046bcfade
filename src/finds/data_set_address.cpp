#include "finds/data_set_address.hpp"

#include "base/hash_name.hpp"
#include "finds/content_address.hpp"

namespace ccdfuzz {

std::string data_set_address(const std::vector<NamedCase>& cases) {
  std::string text;
  for (const NamedCase& named : cases) {
    const std::optional<bool>& collides = named.value.truth.collides;
    text += content_address(named.value.query) + (!collides ? '?' : *collides ? '+' : '-');
  }
  return hash_name(text);
}

}  // namespace ccdfuzz
