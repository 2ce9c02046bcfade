#pragma once

#include <cstdint>
#include <string>

namespace ccdfuzz {

/// What the calling thread is at. A fatal signal there (SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT)
/// writes "ccdfuzz: SIGNAL", before, index and after to stderr, and then ends the program as it
/// would have. A signal that something else handles stays with it; AddressSanitizer's report is
/// followed by the same words. Not to be nested.
class CrashSite {
 public:
  /// Both texts must outlive this.
  CrashSite(const std::string& before, std::uint64_t index, const std::string& after);
  ~CrashSite();
  CrashSite(const CrashSite&) = delete;
  CrashSite& operator=(const CrashSite&) = delete;
};

}  // namespace ccdfuzz
