#pragma once

#include <chrono>
#include <filesystem>
#include <random>
#include <string>
#include <thread>
#include <vector>

#include "generators/draw/draw.hpp"
#include "process.hpp"

namespace ccdfuzz {

/// The size of a file that may come and go, 0 of one that is not there.
inline std::uintmax_t size_or_zero(const std::string& path) {
  std::error_code none;
  const std::uintmax_t size = std::filesystem::file_size(path, none);
  return none ? 0 : size;
}

/// What a command leaves that is sent a signal once this file of its has so many bytes.
inline Finished ended_by(int signal, const std::vector<std::string>& command,
                         const std::string& path, std::uintmax_t bytes) {
  Process process(command);
  while (size_or_zero(path) < bytes && !process.is_over()) std::this_thread::yield();
  process.signal(signal);
  return process.wait();
}

/// Runs ccdfuzz until its run file has grown and kills it up to 20 ms later; `kills` times, each
/// run resuming the one before. A run may end before it is killed, if this process gets no time.
/// Then it calls `forget`, which removes what was written, and starts over. Returns false after
/// `kAttempts` such attempts.
template <class Forget>
bool kill_often(const std::vector<std::string>& arguments, const std::string& journal, int kills,
                const Forget& forget) {
  constexpr int kAttempts = 100;
  Draw random{Random(std::random_device{}())};
  for (int attempt = 0; attempt < kAttempts; ++attempt) {
    bool is_killed = true;
    for (int kill = 0; kill < kills && is_killed; ++kill) {
      const std::uintmax_t before = size_or_zero(journal);
      Process process(arguments);
      while (size_or_zero(journal) <= before && !process.is_over()) std::this_thread::yield();
      std::this_thread::sleep_for(std::chrono::microseconds(random.below(20'000)));
      process.signal(SIGKILL);
      is_killed = process.wait().code == 128 + SIGKILL && std::filesystem::exists(journal);
    }
    if (is_killed) return true;
    forget();
  }
  return false;
}

}  // namespace ccdfuzz
