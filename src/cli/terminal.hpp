#pragma once

#include <chrono>
#include <cstdint>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>

namespace ccdfuzz {

/// One line on stderr that is rewritten in place, at most ten times a second. If stderr is no
/// terminal, a line after 20 s and then each time that twice as long has passed, or ten minutes.
/// Safe to call from several threads.
class Progress {
 public:
  Progress();
  ~Progress() { clear(); }
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// share: how much is done, in [0, 1]. The time left follows from its growth since the first
  /// call, as an earlier run may have done a part. note: what to show beside the bar, of one line.
  /// done: how many `unit`s so far, of which the rate is shown.
  void show(double share, const std::string& note, std::uint64_t done, std::string_view unit);
  /// Wipes the line, so that other output may follow.
  void clear();

 private:
  std::mutex mutex_;
  const bool on_terminal_;
  bool drawn_ = false;
  const std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  std::chrono::steady_clock::time_point next_;
  struct Seen {
    double share;
    std::chrono::steady_clock::time_point at;
  };
  std::optional<Seen> first_;
};

}  // namespace ccdfuzz
