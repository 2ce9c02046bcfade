#pragma once

#include <string>
#include <vector>

#include "files/case_files.hpp"
#include "sound.hpp"

namespace ccdfuzz {

/// The stored counterexamples, one an execution. The execution checks what is known of it, traces
/// its contacts, and asks every method of which the entry expects something.
class CorpusDriver {
 public:
  /// Reads them all. An error of it is what the first execution finds.
  explicit CorpusDriver(const std::string& corpus);
  std::uint64_t size() const { return entries_.size(); }
  std::string operator()(std::uint64_t index);

 private:
  std::string trouble_;
  std::vector<NamedCase> entries_;
  MethodSet methods_;
};

}  // namespace ccdfuzz
