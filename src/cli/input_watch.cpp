#include "cli/input_watch.hpp"

#include <fmt/format.h>

#include <optional>
#include <utility>

namespace ccdfuzz {

namespace {

using Clock = std::chrono::steady_clock;

/// Between two looks of the watch.
constexpr std::chrono::milliseconds kPause{50};

/// What the watch saw of a slot.
struct Seen {
  std::uint64_t turn = 0;
  Clock::time_point since;
  bool told_slow = false, told_interrupted = false;
};

}  // namespace

InputWatch::InputWatch(WatchedInputs inputs, int threads, const std::atomic<bool>& interrupted,
                       Tell tell, Patience patience)
    : inputs_(std::move(inputs)),
      crash_before_(
          fmt::format(" on an input of {}\nreproduce: {}", inputs_.property, inputs_.before)),
      crash_after_(inputs_.after + "\n"),
      slots_(static_cast<std::size_t>(threads)),
      interrupted_(interrupted),
      tell_(std::move(tell)),
      patience_(patience),
      thread_([this] { look_on(); }) {}

InputWatch::~InputWatch() {
  {
    const std::lock_guard lock(mutex_);
    end_ = true;
  }
  ended_.notify_one();
  thread_.join();
}

InputWatch::Slot& InputWatch::take_slot() {
  // The one that the thread had the last time is free, as a rule.
  thread_local std::size_t own = 0;
  for (own %= slots_.size();; own = (own + 1) % slots_.size()) {
    std::uint64_t turn = slots_[own].turn.load(std::memory_order_relaxed);
    if (turn % 2 == 0 && slots_[own].turn.compare_exchange_strong(turn, turn + 1)) {
      return slots_[own];
    }
  }
}

InputWatch::At::At(InputWatch& watch, std::uint64_t index)
    : slot_(watch.take_slot()), site_(watch.crash_before_, index, watch.crash_after_) {
  slot_.index = index;
}

InputWatch::At::~At() {
  ++slot_.turn;
}

std::string InputWatch::told(const char* what, std::uint64_t index) const {
  return fmt::format("ccdfuzz: {} an input of {}, or its shrinking\nreproduce: {}{}{}\n", what,
                     inputs_.property, inputs_.before, index, inputs_.after);
}

void InputWatch::look_on() {
  const std::string slow =
      fmt::format("for {} s now at", std::chrono::duration<double>(patience_.slow).count());
  std::vector<Seen> seen(slots_.size());
  std::optional<Clock::time_point> interruption;
  std::unique_lock lock(mutex_);
  while (!ended_.wait_for(lock, kPause, [this] { return end_; })) {
    const Clock::time_point now = Clock::now();
    if (interrupted_ && !interruption) interruption = now;
    for (std::size_t i = 0; i < slots_.size(); ++i) {
      const std::uint64_t turn = slots_[i].turn;
      if (turn != seen[i].turn) seen[i] = {turn, now};
      if (turn % 2 == 0 || now == seen[i].since) continue;  // its index may be still to come
      const std::uint64_t index = slots_[i].index;
      if (slots_[i].turn != turn) continue;
      if (!seen[i].told_slow && now - seen[i].since >= patience_.slow) {
        seen[i].told_slow = true;
        tell_(told(slow.c_str(), index));
      }
      if (interruption && !seen[i].told_interrupted &&
          now - *interruption >= patience_.interrupted) {
        seen[i].told_interrupted = true;
        tell_(told("a second signal ends the program; the first waits for", index));
      }
    }
  }
}

}  // namespace ccdfuzz
