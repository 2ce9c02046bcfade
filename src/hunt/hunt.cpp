#include "hunt/hunt.hpp"

#include <tbb/enumerable_thread_specific.h>

#include <algorithm>
#include <chrono>
#include <exception>
#include <mutex>
#include <thread>

#include "eval/cpu_time.hpp"
#include "eval/in_order.hpp"
#include "hunt/draw.hpp"
#include "hunt/scheduler.hpp"
#include "hunt/trophies.hpp"
#include "numeric/verify.hpp"

namespace ccdfuzz {

namespace {

/// What one method said of one draw.
struct Turn {
  size_t cell = 0;
  std::vector<Judged> judged;  ///< one for each of the draw's queries, fewer if stopped
  double cpu_seconds = 0;
};

class Hunt {
 public:
  Hunt(const HuntOptions& options, Store& store,
       const std::function<void(const HuntProgress&)>& on_progress, const std::atomic<bool>& stop)
      : options_(options),
        on_progress_(on_progress),
        stop_(stop),
        trophies_(store, options),
        draws_(options.seed) {
    for (const ContactClass contact : kContactClasses) {
      for (const std::string& method : options.methods) {
        report_.cells.push_back({method, contact, {}, 0});
      }
    }
  }

  HuntReport run() {
    if (options_.cases) {
      hunt_cases(*options_.cases);
    } else {
      hunt_by_time();
    }
    if (failure_) std::rethrow_exception(failure_);
    if (!report_.error && !stop_) note(trophies_.complete(stop_));
    Result<std::vector<HuntFind>> finds = trophies_.finds();
    if (finds) {
      report_.finds = std::move(*finds);
    } else if (!report_.error) {
      report_.error = finds.error();
    }
    report_.seconds = elapsed();
    return std::move(report_);
  }

 private:
  size_t method_count() const { return options_.methods.size(); }

  double elapsed() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  }

  void note(const Result<void>& result) {
    if (result || report_.error) return;
    report_.error = result.error();
    ended_ = true;
  }

  Turn take_turn(size_t cell, const Draw& drawn, MethodSet& methods) const {
    Turn turn{cell, {}, 0};
    Method& method = methods[report_.cells[cell].method];
    // What answers in another process costs what we wait for it.
    const auto cost_so_far = [&] {
      return method.runs_elsewhere() ? elapsed() : thread_cpu_seconds();
    };
    const double start = cost_so_far();
    for (const Case& asked : drawn.asked) {
      if (stop_) break;
      turn.judged.push_back(ask(method, asked, options_.search));
    }
    turn.cpu_seconds = cost_so_far() - start;
    return turn;
  }

  /// Counts a turn and stores what it found. The caller sees to it that turns come one at a time.
  void record(const Turn& turn, const Draw& drawn) {
    HuntCell& cell = report_.cells[turn.cell];
    cell.cpu_seconds += turn.cpu_seconds;
    for (size_t q = 0; q < turn.judged.size(); ++q) {
      const Judged& judged = turn.judged[q];
      cell.tally.add(judged.answer, judged.outcome, drawn.asked[q].truth.collides);
      ++queries_;
      if (is_failure(judged.outcome) && !report_.error) {
        note(trophies_.offer(cell.method, drawn.asked[q], judged));
      }
    }
  }

  void show(double share) const {
    on_progress_({std::min(share, 1.0), queries_, trophies_.count()});
  }

  /// Draw by draw and class by class, every draw to every method; recorded in that order.
  void hunt_cases(std::uint64_t count) {
    struct Answered {
      Draw drawn;
      std::vector<Turn> turns;
      double draw_cpu_seconds = 0;
    };
    const size_t classes = kContactClasses.size();
    const size_t total = count * classes;
    tbb::enumerable_thread_specific<MethodSet> methods;
    run_in_order<Answered>(
        total, options_.threads,
        [&](size_t i) {
          const size_t contact = i % classes;
          const double start = thread_cpu_seconds();
          Answered answered{draw(kContactClasses[contact], options_.seed, i / classes), {}, 0};
          answered.draw_cpu_seconds = thread_cpu_seconds() - start;
          for (size_t m = 0; m < method_count() && !stop_; ++m) {
            answered.turns.push_back(
                take_turn(contact * method_count() + m, answered.drawn, methods.local()));
          }
          return answered;
        },
        [&](const Answered& answered) {
          for (const Turn& turn : answered.turns) record(turn, answered.drawn);
          ++report_.cases;
          report_.draw_cpu_seconds += answered.draw_cpu_seconds;
          show(static_cast<double>(report_.cases) / static_cast<double>(total));
          if (stop_) ended_ = true;
        },
        &ended_);
  }

  void hunt_by_time() {
    scheduler_ = Scheduler(report_.cells.size());
    next_draw_.assign(report_.cells.size(), 0);
    std::vector<std::jthread> workers;
    for (int t = 1; t < options_.threads; ++t) workers.emplace_back([this] { work(); });
    work();
  }

  /// One thread of a hunt by time.
  void work() {
    try {
      MethodSet methods;
      std::unique_lock lock(mutex_);
      while (!stop_ && !ended_ && elapsed() < options_.seconds) {
        // The scheduler starts with its first cell: let that be of the class with the cheapest
        // queries, so that a short hunt sees most classes before it comes to the slow ones.
        const size_t turn_of = scheduler_.begin();
        const size_t cell = report_.cells.size() - 1 - turn_of;
        const std::uint64_t index = next_draw_[cell]++;
        lock.unlock();
        const double start = thread_cpu_seconds();
        const std::shared_ptr<const Draw> drawn = draws_.get(report_.cells[cell].contact, index);
        const double draw_cpu = thread_cpu_seconds() - start;
        const Turn turn = take_turn(cell, *drawn, methods);
        lock.lock();
        scheduler_.end(turn_of, turn.cpu_seconds);
        report_.draw_cpu_seconds += draw_cpu;
        record(turn, *drawn);
        show(elapsed() / options_.seconds);
      }
      count_cases();
    } catch (...) {
      const std::lock_guard lock(mutex_);
      if (!failure_) failure_ = std::current_exception();
      ended_ = true;
    }
  }

  /// The draws of a class that were put to any method: as far as the fastest got.
  void count_cases() {
    report_.cases = 0;
    for (size_t c = 0; c < next_draw_.size(); c += method_count()) {
      const auto first = next_draw_.begin() + static_cast<std::ptrdiff_t>(c);
      report_.cases +=
          *std::max_element(first, first + static_cast<std::ptrdiff_t>(method_count()));
    }
  }

  const HuntOptions& options_;
  const std::function<void(const HuntProgress&)>& on_progress_;
  const std::atomic<bool>& stop_;
  const std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  Trophies trophies_;
  DrawCache draws_;

  std::mutex mutex_;  ///< of all below, while workers run
  Scheduler scheduler_{0};
  std::vector<std::uint64_t> next_draw_;
  HuntReport report_;
  std::uint64_t queries_ = 0;
  std::exception_ptr failure_;
  std::atomic<bool> ended_ = false;  ///< the store or a worker failed, or stop was seen
};

}  // namespace

HuntReport hunt(const HuntOptions& options, Store& store,
                const std::function<void(const HuntProgress&)>& on_progress,
                const std::atomic<bool>& stop) {
  CCDFUZZ_VERIFY(!options.methods.empty() && options.threads >= 1 &&
                 options.search.precision == SearchOptions().precision);
  return Hunt(options, store, on_progress, stop).run();
}

}  // namespace ccdfuzz
