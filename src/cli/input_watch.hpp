#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "cli/crash_report.hpp"

namespace ccdfuzz {

/// The inputs of one property. One is shown again by the command "before", its index, "after".
struct WatchedInputs {
  std::string property;
  std::string before, after;
};

/// Knows which input each thread is at, so that one that does not come to an end can be shown
/// again: what crashes is told as CrashSite does, what takes long or is waited for after an
/// interruption is told once.
class InputWatch {
 public:
  struct Patience {
    std::chrono::milliseconds slow;
    std::chrono::milliseconds interrupted;
  };
  /// As -timeout in script/fuzz; and what ends within a second need not be told.
  static constexpr Patience kPatience{std::chrono::seconds(60), std::chrono::milliseconds(500)};
  using Tell = std::function<void(const std::string&)>;

  /// At most `threads` are at inputs at once. tell is called from a thread of the watch.
  InputWatch(WatchedInputs inputs, int threads, const std::atomic<bool>& interrupted, Tell tell,
             Patience patience = kPatience);
  ~InputWatch();
  InputWatch(const InputWatch&) = delete;
  InputWatch& operator=(const InputWatch&) = delete;

 private:
  /// Of one thread at a time; on a cache line of its own.
  struct alignas(64) Slot {
    std::atomic<std::uint64_t> turn = 0;  ///< odd while a thread is at an input
    std::atomic<std::uint64_t> index = 0;
  };

 public:
  /// The calling thread is at an input as long as this lives. Not to be nested.
  class At {
   public:
    At(InputWatch& watch, std::uint64_t index);
    ~At();
    At(const At&) = delete;
    At& operator=(const At&) = delete;

   private:
    Slot& slot_;
    CrashSite site_;
  };

 private:
  Slot& take_slot();
  void look_on();
  std::string told(const char* what, std::uint64_t index) const;

  const WatchedInputs inputs_;
  const std::string crash_before_, crash_after_;
  std::vector<Slot> slots_;
  const std::atomic<bool>& interrupted_;
  const Tell tell_;
  const Patience patience_;
  std::mutex mutex_;
  std::condition_variable ended_;
  bool end_ = false;
  std::thread thread_;  ///< the last member: it reads the others
};

}  // namespace ccdfuzz
