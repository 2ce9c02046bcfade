#include "hunt/hunt.hpp"

#include <tbb/enumerable_thread_specific.h>

#include <algorithm>
#include <chrono>
#include <exception>
#include <mutex>
#include <thread>
#include <tuple>

#include "base/cpu_time.hpp"
#include "base/in_order.hpp"
#include "base/verify.hpp"
#include "hunt/draw.hpp"
#include "hunt/scheduler.hpp"
#include "hunt/trophies.hpp"

namespace ccdfuzz {

namespace {

/// Mutants that a method meets for each draw of a hunt by cases.
constexpr std::uint64_t kMutantsPerDraw = 16;
/// Draws that such a population begins with.
constexpr std::uint64_t kFounders = 64;

/// Of a hunt by cases; the rest of it goes by the populations bred.
constexpr double kDrawingShare = 0.5;

/// What one method said of one draw.
struct Turn {
  size_t cell = 0;
  std::vector<Judged> judged;  ///< one for each of the draw's queries, fewer if stopped
  double cpu_seconds = 0;
  double answer_seconds = 0;  ///< of those, for what it did not refuse
};

/// A counterexample on its way to the store.
struct Found {
  Case asked;
  Judged judged;
};

/// The population of one cell. Its time is no more than what the cell's draws took.
struct Nursery {
  Breeder breeder;
  bool taken = false;  ///< by a thread; another goes without
  double drawn_seconds = 0, bred_seconds = 0;

  bool is_behind() const { return !taken && !breeder.empty() && bred_seconds < drawn_seconds; }
};

/// A hunt by time depends on the clock anyway: no query may hold up its end, or Ctrl-C, for longer
/// than this. Pops alone do not bound that: one of exact arithmetic on high degrees takes 50 ms. A
/// plug-in is told so, and begins nothing new with a query after it; but what it was asked it has
/// its own time for (seconds=S), so that it may hold up the end for so long besides.
constexpr double kLongestQuerySeconds = 5;

HuntOptions within_its_time(HuntOptions options) {
  if (!options.cases) {
    options.search.max_seconds = std::min(options.search.max_seconds, kLongestQuerySeconds);
  }
  return options;
}

class Hunt {
 public:
  Hunt(const HuntOptions& options, Store& store,
       const std::function<void(const HuntProgress&)>& on_progress, const std::atomic<bool>& stop)
      : options_(within_its_time(options)),
        on_progress_(on_progress),
        stop_(stop),
        trophies_(store, options_),
        draws_(options.seed, options.ground) {
    for (const ContactClass contact : draws_.classes()) {
      for (const std::string& method : options.methods) {
        const std::uint64_t seed = Random::keyed({options.seed, report_.cells.size()}).next();
        nurseries_.push_back(Nursery{Breeder(method, seed, options.ground)});
        report_.cells.push_back({method, contact, {}, 0, {}});
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
    for (size_t c = 0; c < nurseries_.size(); ++c) count_bred(c);
    if (!stop_) shrink();
    Result<void> stored;
    if (!stop_) stored = trophies_.complete(stop_);
    if (const auto all = trophies_.store_all(); !all) stored = all;
    if (!stored) report_.error = stored.error();
    report_.finds = trophies_.finds();
    report_.seconds = elapsed();
    show(1);
    return std::move(report_);
  }

 private:
  /// By time, at most as long again as the hunt, but long enough for a short one's finds.
  void shrink() {
    const double until = options_.cases ? std::numeric_limits<double>::infinity()
                                        : elapsed() + std::max(options_.seconds, 20.0);
    // What cannot be stored now may be stored later, as it is.
    std::ignore = trophies_.shrink([this, until] { return stop_ || elapsed() > until; });
  }

  size_t method_count() const { return options_.methods.size(); }

  double elapsed() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  }

  /// What answers in another process costs what we wait for it.
  double clock_of(const Method& method) const {
    return method.runs_elsewhere() ? elapsed() : thread_cpu_seconds();
  }

  Turn take_turn(size_t cell, const Draw& drawn, MethodSet& methods) const {
    Turn turn{cell, {}, 0, 0};
    Method& method = methods[report_.cells[cell].method];
    for (const CheckedCase& asked : drawn.asked) {
      if (stop_) break;
      const double start = clock_of(method);
      turn.judged.push_back(ask(method, asked, options_.search));
      const double used = clock_of(method) - start;
      turn.cpu_seconds += used;
      if (turn.judged.back().outcome != Outcome::kNotAsked) turn.answer_seconds += used;
    }
    return turn;
  }

  /// Counts a turn and stores what it found. The caller sees to it that turns come one at a time.
  void record(const Turn& turn, const Draw& drawn) {
    HuntCell& cell = report_.cells[turn.cell];
    cell.cpu_seconds += turn.answer_seconds;
    for (size_t q = 0; q < turn.judged.size(); ++q) {
      const Judged& judged = turn.judged[q];
      cell.tally.add(judged.answer, judged.outcome, drawn.asked[q].collides());
      if (judged.outcome != Outcome::kNotAsked) ++queries_;
      if (is_failure(judged.outcome)) {
        trophies_.offer(cell.method, drawn.asked[q].value(), judged);
      }
    }
  }

  void offer(const std::string& method, const Found& found) {
    trophies_.offer(method, found.asked, found.judged);
  }

  void show(double share) const {
    HuntProgress now{std::min(share, 1.0), queries_, 0, trophies_.count(), {}, trophies_.trouble()};
    now.margins.resize(method_count());
    for (size_t c = 0; c < report_.cells.size(); ++c) {
      const BreedTally& bred = report_.cells[c].bred;
      std::optional<std::uint64_t>& least = now.margins[c % method_count()];
      now.mutants += bred.mutants;
      if (bred.margin && (!least || *bred.margin < *least)) least = bred.margin;
    }
    on_progress_(now);
  }

  /// What the population of a cell has come to, for others to see; its thread says so.
  void count_bred(size_t cell) { report_.cells[cell].bred = nurseries_[cell].breeder.tally(); }

  /// Steps of the cell's population while more() says so; what they found.
  template <class More>
  std::vector<Found> breed(size_t cell, MethodSet& methods, TracerSet& tracers, const More& more) {
    std::vector<Found> found;
    const auto keep = [&](const Case& asked, const Judged& judged) {
      found.push_back({asked, judged});
    };
    while (!stop_ && more()) {
      nurseries_[cell].breeder.step(methods, tracers, options_.search, keep);
    }
    return found;
  }

  void hunt_cases(std::uint64_t count) {
    ask_draws(count);
    if (!stop_ && !ended_) breed_draws(count);
  }

  /// Every cell's population on its own, founded by the first draws.
  void breed_draws(std::uint64_t count) {
    struct Workshop {
      MethodSet methods;
      TracerSet tracers;
    };
    tbb::enumerable_thread_specific<Workshop> workshops;
    const size_t populations = report_.cells.size();
    size_t recorded = 0;
    run_in_order<std::vector<Found>>(
        populations, options_.threads,
        [&](size_t cell) {
          Workshop& workshop = workshops.local();
          Breeder& breeder = nurseries_[cell].breeder;
          for (std::uint64_t i = 0; i < std::min(count, kFounders); ++i) {
            const auto drawn = latest_.get(report_.cells[cell].contact, i);
            for (const CheckedCase& asked : drawn->asked) {
              breeder.add(asked.value(), workshop.tracers);
            }
          }
          std::uint64_t left = count * kMutantsPerDraw;
          return breed(cell, workshop.methods, workshop.tracers, [&] { return left-- > 0; });
        },
        [&](const std::vector<Found>& all) {
          const size_t cell = recorded++;
          for (const Found& found : all) offer(report_.cells[cell].method, found);
          count_bred(cell);
          show(kDrawingShare + (1 - kDrawingShare) * static_cast<double>(recorded) /
                                   static_cast<double>(populations));
          if (stop_) ended_ = true;
        },
        &ended_);
  }

  /// Draw by draw and class by class, every draw to every method; recorded in that order.
  void ask_draws(std::uint64_t count) {
    struct Answered {
      Draw drawn;
      std::vector<Turn> turns;
      double draw_cpu_seconds = 0;
    };
    const size_t classes = draws_.classes().size();
    const std::uint64_t total = count * classes;
    tbb::enumerable_thread_specific<MethodSet> methods;
    run_in_order<Answered>(
        total, options_.threads,
        [&](size_t i) {
          const size_t contact = i % classes;
          const double start = thread_cpu_seconds();
          Answered answered{draws_.at(draws_.classes()[contact], i / classes), {}, 0};
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
          show(kDrawingShare * static_cast<double>(report_.cases) / static_cast<double>(total));
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
      TracerSet tracers;
      std::unique_lock lock(mutex_);
      while (!stop_ && !ended_ && elapsed() < options_.seconds) {
        // The scheduler starts with its first cell: let that be of the class with the cheapest
        // queries, so that a short hunt sees most classes before it comes to the slow ones.
        const size_t turn_of = scheduler_.begin();
        const size_t cell = report_.cells.size() - 1 - turn_of;
        const double used = nurseries_[cell].is_behind()
                                ? take_breeding_turn(cell, methods, tracers, lock)
                                : take_drawing_turn(cell, methods, tracers, lock);
        scheduler_.end(turn_of, used);
        show(elapsed() / options_.seconds);
      }
      count_cases();
    } catch (...) {
      const std::lock_guard lock(mutex_);
      if (!failure_) failure_ = std::current_exception();
      ended_ = true;
    }
  }

  /// One draw, put to the cell's method. Returns the CPU time of that, what it took to make the
  /// draw included: a cell that goes ahead of the others of its class makes them for all.
  double take_drawing_turn(size_t cell, MethodSet& methods, TracerSet& tracers,
                           std::unique_lock<std::mutex>& lock) {
    Nursery& nursery = nurseries_[cell];
    const bool founds = !std::exchange(nursery.taken, true);
    const std::uint64_t index = next_draw_[cell]++;
    lock.unlock();
    const double start = thread_cpu_seconds();
    const std::shared_ptr<const Draw> drawn = latest_.get(report_.cells[cell].contact, index);
    const double draw_cpu = thread_cpu_seconds() - start;
    const Turn turn = take_turn(cell, *drawn, methods);
    const double founding = thread_cpu_seconds();
    for (const CheckedCase& asked : drawn->asked) {
      if (founds) nursery.breeder.add(asked.value(), tracers);
    }
    const double used = draw_cpu + turn.cpu_seconds + (thread_cpu_seconds() - founding);
    lock.lock();
    if (founds) {
      nursery.taken = false;
      count_bred(cell);
    }
    nursery.drawn_seconds += used;
    report_.draw_cpu_seconds += draw_cpu;
    record(turn, *drawn);
    return used;
  }

  /// A slice of time for the cell's population. Returns the CPU time of that.
  double take_breeding_turn(size_t cell, MethodSet& methods, TracerSet& tracers,
                            std::unique_lock<std::mutex>& lock) {
    constexpr double kSlice = 0.02;
    Nursery& nursery = nurseries_[cell];
    nursery.taken = true;
    lock.unlock();
    const Method& method = methods[report_.cells[cell].method];
    const double start = clock_of(method);
    const auto used = [&] { return clock_of(method) - start; };
    const std::vector<Found> all =
        breed(cell, methods, tracers, [&] { return !ended_ && used() < kSlice; });
    const double seconds = used();
    lock.lock();
    nursery.taken = false;
    nursery.bred_seconds += seconds;
    count_bred(cell);
    for (const Found& found : all) offer(report_.cells[cell].method, found);
    return seconds;
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

  const HuntOptions options_;
  const std::function<void(const HuntProgress&)>& on_progress_;
  const std::atomic<bool>& stop_;
  const std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  Trophies trophies_;
  const Draws draws_;
  DrawCache latest_{draws_};
  std::vector<Nursery> nurseries_;  ///< one a cell

  std::mutex mutex_;  ///< of all below, while workers run
  Scheduler scheduler_{0};
  std::vector<std::uint64_t> next_draw_;
  HuntReport report_;
  std::uint64_t queries_ = 0;
  std::exception_ptr failure_;
  std::atomic<bool> ended_ = false;  ///< a worker failed, or stop was seen
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
