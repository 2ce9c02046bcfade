#pragma once

#include <optional>
#include <string>
#include <vector>

#include "hunt/breeder.hpp"
#include "sound.hpp"

namespace ccdfuzz {

/// What of a hunt a driver does.
struct HuntParts {
  Look look;
  std::optional<Aim> bred;  ///< absent: no mutants
};

/// By turns a generated contact, and mutants of those that there were, bred towards what one of the
/// methods nearly loses, or by chance.
class HuntDriver {
 public:
  HuntDriver(std::uint64_t seed, const HuntParts& parts);
  /// One execution: what is wrong, or nothing.
  std::string operator()(std::uint64_t index);

 private:
  std::string generate(std::uint64_t index);

  std::uint64_t seed_;
  HuntParts parts_;
  MethodSet methods_;
  std::vector<Breeder> breeders_;
};

}  // namespace ccdfuzz
