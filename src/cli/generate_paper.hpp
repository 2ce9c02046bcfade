#pragma once

#include <cstdint>
#include <string>

#include "base/result.hpp"
#include "base/shard.hpp"

namespace ccdfuzz {

struct GeneratePaperOptions {
  std::uint64_t seed = 0;
  std::uint64_t one_in = 1;
  Shard shard;
  std::string output;
  int threads = 1;
  bool json = false;
};

/// `generate --paper`: the paper's whole set, by a journal beside the output, so that a run which
/// was killed goes on where it was. Prints Table 4. Returns the exit code.
Result<int> generate_paper(const GeneratePaperOptions& options);

}  // namespace ccdfuzz
