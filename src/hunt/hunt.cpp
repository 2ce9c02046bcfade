#include "hunt/hunt.hpp"

#include <tbb/enumerable_thread_specific.h>

#include <algorithm>
#include <iterator>
#include <limits>
#include <map>
#include <mutex>
#include <utility>

#include "base/fp_guard.hpp"
#include "base/no_process.hpp"
#include "base/stopwatch.hpp"
#include "base/verify.hpp"
#include "hunt/draw.hpp"
#include "hunt/schedule.hpp"
#include "io/cpu_time.hpp"
#include "io/in_order.hpp"
#include "io/json_write.hpp"
#include "method/plugin/plugin_spec.hpp"
#include "method/served_method.hpp"

namespace ccdfuzz {

namespace {

/// Mutants that a method meets for each draw of a hunt by cases.
constexpr std::uint64_t kMutantsPerDraw = 16;
/// Draws that such a population begins with.
constexpr std::uint64_t kFounders = 64;
/// CPU time of a breeding turn of a hunt by time.
constexpr double kSlice = 0.02;

/// The result of a turn.
struct Done {
  Tally tally;              ///< for a draw
  LogHistogram beside;      ///< for a draw, as of HuntCell
  double cpu_seconds = 0;   ///< in all
  double draw_seconds = 0;  ///< the part for making the draw
  bool bred = true;         ///< false: there was nothing to make mutants of
  BreedTally population;    ///< for a breeding turn
  std::vector<std::pair<Failure, Case>> failures;
  std::vector<Failure> met;  ///< the new ones among them
};

/// The contacts of one cell that are bred, and how many of its draws have joined them.
struct Nursery {
  Breeder breeder;
  Draws draws;
  std::uint64_t founded = 0;
  /// Draws that were asked about and have not joined yet, by index.
  std::map<std::uint64_t, std::vector<CheckedCase>> waiting = {};
};

/// A hunt by time depends on the clock anyway. A plug-in is asked nothing more about a query after
/// kLongestQuerySeconds. For the question that it has it may take its own time (seconds=S), and so
/// delay the end by that, but not by the stop.
HuntOptions until_its_end(HuntOptions options, const std::atomic<bool>& stop) {
  if (!options.cases) options.search = limited(options.search);
  options.search.stop = &stop;
  return options;
}

class Hunt {
 public:
  Hunt(const HuntOptions& options, Store& store,
       const std::function<void(const HuntProgress&)>& on_progress, const std::atomic<bool>& stop)
      : options_(until_its_end(options, stop)),
        on_progress_(on_progress),
        stop_(stop),
        intake_(
            store, [this] { return Asker(options_.search); },
            // Stored entries may have been met with any number of pops.
            [this] { return Asker(limited(options_.search), MethodSet(make_served_method)); }),
        schedule_(make_cells(), options.cases) {}

  HuntReport run() {
    const FpGuard guard;
    tbb::enumerable_thread_specific<Asker> askers([this] { return Asker(options_.search); });
    stream_in_order<std::pair<Turn, Done>>(
        options_.threads, [this] { return next_turn(); },
        [&](const Turn& turn) {
          Asker& asker = askers.local();
          Done done = turn.what == Turn::What::kDraw ? draw(turn, asker) : breed(turn, asker);
          if (!options_.cases) offer(done);
          return std::pair(turn, std::move(done));
        },
        [this](std::pair<Turn, Done> next) {
          auto& [turn, done] = next;
          if (options_.cases && met_) return;  // another thread was ahead
          if (options_.cases) offer(done);
          const std::lock_guard lock(mutex_);
          record(turn, done);
        },
        // So that a hunt by cases repeats, its course too.
        options_.cases ? Order::kOfItems : Order::kNone);
    count_cases();
    unless_refused([&] {
      const bool ends_early = stop_ || report_.refused;
      const Result<void> stored = ends_early ? intake_.store_all() : finish();
      if (!stored) report_.error = stored.error();
    });
    report_.finds = intake_.finds();
    report_.seconds = watch_.seconds();
    show(1);
    return std::move(report_);
  }

 private:
  /// A cell for each class that there are draws of, and each method that they are for. Returns how
  /// many.
  size_t make_cells() {
    std::vector<Draws> draws;
    std::vector<ContactClass> classes;
    for (const std::string& method : options_.methods) {
      const Features taken = value_or_throw(method_info(method)).features;
      draws.emplace_back(options_.seed, options_.ground, taken);
      std::ranges::copy_if(draws.back().classes(), std::back_inserter(classes), [&](auto contact) {
        return std::ranges::find(classes, contact) == classes.end();
      });
    }
    for (const ContactClass contact : classes) {
      for (size_t m = 0; m < draws.size(); ++m) {
        const std::string& method = options_.methods[m];
        const auto& own = draws[m].classes();
        if (std::ranges::find(own, contact) == own.end()) continue;
        const std::uint64_t seed = Random::keyed({options_.seed, report_.cells.size()}).next();
        nurseries_.push_back({Breeder(method, seed, options_.ground), draws[m]});
        report_.cells.push_back({method, contact, {}, {}, {}});
      }
    }
    return report_.cells.size();
  }

  /// A method in another process costs the time that we wait for it.
  double clock_of(const Method& method) const {
    return method.runs_elsewhere() ? watch_.seconds() : thread_cpu_seconds();
  }

  std::optional<Turn> next_turn() {
    const std::lock_guard lock(mutex_);
    return is_over() ? std::nullopt : schedule_.next();
  }

  bool is_over() const { return stop_ || met_ || report_.refused || is_late(); }
  bool is_late() const { return !options_.cases && watch_.seconds() >= options_.seconds; }

  /// Where no process answers, and not because of the stop, the hunt ends with what it has.
  template <class Work>
  void unless_refused(const Work& work) {
    try {
      work();
    } catch (const NoProcess&) {
      const std::lock_guard lock(mutex_);
      if (!stop_) report_.refused = std::current_exception();
    }
  }

  /// The limits of a question that is asked now. A hunt by time ends those to methods of its own
  /// process with its time. A plug-in may not heed a limit, and is ended by that of its own.
  SearchOptions search_now(const Method& method) const {
    SearchOptions search = options_.search;
    if (options_.cases || method.runs_elsewhere()) return search;
    search.max_seconds = std::min(search.max_seconds, options_.seconds - watch_.seconds());
    return search;
  }

  /// Whether the end of the hunt made it undecided: then it counts as not asked.
  bool is_cut_off(const Judged& judged) const {
    return judged.outcome == Outcome::kUndecided && is_late();
  }

  /// Whether a turn is to end before its end.
  bool stops() const { return stop_ || is_in_vain(); }

  /// How many draws of a cell are bred of, of so many begun.
  std::uint64_t founders_of(std::uint64_t begun) const {
    if (options_.ground.uniform) return 0;
    return options_.cases ? std::min(begun, kFounders) : begun;
  }

  /// A draw of the cell that joins its population: the one that was asked about, unless another
  /// thread is still at it.
  std::vector<CheckedCase> founder(size_t cell, std::uint64_t index) {
    Nursery& nursery = nurseries_[cell];
    {
      const std::lock_guard lock(mutex_);
      if (auto drawn = nursery.waiting.extract(index)) return std::move(drawn.mapped());
    }
    return nursery.draws.at(report_.cells[cell].contact, index);
  }

  /// Asks the method of the cell about one draw.
  Done draw(const Turn& turn, Asker& asker) {
    Done done;
    const HuntCell& cell = report_.cells[turn.cell];
    const double start = thread_cpu_seconds();
    Nursery& nursery = nurseries_[turn.cell];
    std::vector<CheckedCase> drawn = nursery.draws.at(cell.contact, turn.draw);
    done.draw_seconds = done.cpu_seconds = thread_cpu_seconds() - start;
    Method& method = asker.methods()[cell.method];
    unless_refused([&] {
      for (const CheckedCase& asked : drawn) {
        if (stops()) break;
        const double begin = clock_of(method);
        const Judged judged = ask(method, asked, search_now(method));
        done.cpu_seconds += clock_of(method) - begin;
        if (is_cut_off(judged)) break;
        done.tally.add(judged.answer, judged.outcome, asked.collides(), judged.late_by);
        note_failure(cell.method, asked.value(), judged, asker, done);
        if (!options_.beside || judged.outcome == Outcome::kNotAsked) continue;
        Method& other = asker.methods()[*options_.beside];
        const Judged beside = ask(other, asked, search_now(other));
        if (is_cut_off(beside)) break;
        if (beside.outcome != Outcome::kNotAsked) done.beside.add(beside.answer.seconds);
      }
    });
    if (turn.draw < founders_of(turn.draw + 1)) {
      const std::lock_guard lock(mutex_);
      nursery.waiting.emplace(turn.draw, std::move(drawn));
    }
    return done;
  }

  void note_failure(const std::string& method, const Case& asked, const Judged& judged,
                    Asker& asker, Done& done) const {
    if (!is_failure(judged.outcome)) return;
    const double begin = thread_cpu_seconds();
    Case& find = done.failures.emplace_back(*asker.failure(method, asked, judged), asked).second;
    find.asked = asked_with(options_.search);
    find.expect.clear();
    find.origin.more.erase(kNote);
    const std::string& note = judged.answer.note;
    if (judged.outcome == Outcome::kError && !note.empty()) {
      find.origin.more[kNote] = json_string(note);
    }
    done.cpu_seconds += thread_cpu_seconds() - begin;
  }

  /// Lets the draws that the cell has begun join its population, and makes mutants: by time for a
  /// slice of it.
  Done breed(const Turn& turn, Asker& asker) {
    Done done;
    const HuntCell& cell = report_.cells[turn.cell];
    auto& [breeder, draws, founded, waiting] = nurseries_[turn.cell];
    const Method& method = asker.methods()[cell.method];
    const double start = clock_of(method);
    for (const std::uint64_t all = founders_of(turn.draw); founded < all && !stops(); ++founded) {
      for (const CheckedCase& asked : founder(turn.cell, founded)) {
        breeder.add(asked.value(), asker.methods());
      }
    }
    std::uint64_t left = options_.cases ? turn.draw * kMutantsPerDraw : ~std::uint64_t{0};
    const auto goes_on = [&] {
      return left-- > 0 && !stops() && (options_.cases || clock_of(method) - start < kSlice);
    };
    done.bred = !breeder.empty();
    unless_refused([&] {
      while (done.bred && goes_on()) {
        breeder.step(asker.methods(), search_now(method),
                     [&](const Case& asked, const Judged& judged) {
                       note_failure(cell.method, asked, judged, asker, done);
                     });
      }
    });
    done.cpu_seconds = clock_of(method) - start;
    done.population = breeder.tally();
    return done;
  }

  /// The intake may ask a method about entries of the store: outside of the lock.
  void offer(Done& done) {
    for (const auto& [failure, find] : done.failures) {
      unless_refused([&] {
        if (intake_.offer(failure, find)) done.met.push_back(failure);
      });
    }
  }

  void record(const Turn& turn, const Done& done) {
    HuntCell& cell = report_.cells[turn.cell];
    schedule_.done(turn, done.cpu_seconds, done.bred);
    report_.draw_cpu_seconds += done.draw_seconds;
    cell.tally.merge(done.tally);
    cell.beside.merge(done.beside);
    for (const Failure& failure : done.met) met_ = met_ || failure.outcome == options_.until;
    if (turn.what == Turn::What::kBreed) cell.bred = done.population;
    show(options_.cases ? schedule_.share_done() : watch_.seconds() / options_.seconds, done.met);
  }

  void show(double share, const std::vector<Failure>& met = {}) {
    HuntProgress now;
    now.seconds = watch_.seconds();
    now.finds = intake_.count();
    now.share = std::min(share, 1.0);
    now.trouble = intake_.trouble();
    now.met = met;
    now.margins.resize(options_.methods.size());
    for (const auto& [method, contact, tally, bred, beside] : report_.cells) {
      const auto m = std::ranges::find(options_.methods, method) - options_.methods.begin();
      std::optional<std::uint64_t>& least = now.margins[static_cast<size_t>(m)];
      now.queries += tally.n;
      now.mutants += bred.mutants;
      if (bred.margin && (!least || *bred.margin < *least)) least = bred.margin;
    }
    if (now.share >= next_sample_ || now.share >= 1) {
      report_.course.push_back(now);
      next_sample_ = now.share + 1.0 / 200;
    }
    on_progress_(now);
  }

  /// The draws of each class, as many as any method was put to.
  void count_cases() {
    std::map<ContactClass, std::uint64_t> most;
    for (size_t c = 0; c < report_.cells.size(); ++c) {
      std::uint64_t& draws = most[report_.cells[c].contact];
      draws = std::max(draws, schedule_.draws_done(c));
    }
    for (const auto& [contact, draws] : most) report_.cases += draws;
  }

  /// Shrinks the new finds, in a hunt by time for at most as long again but at least 20 s. Then
  /// asks all methods about them.
  Result<void> finish() {
    const double until = options_.cases ? std::numeric_limits<double>::infinity()
                                        : watch_.seconds() + std::max(options_.seconds, 20.0);
    const auto shrinks = [&](const Failure& failure) {
      return options_.shrink == Shrink::kAll ||
             (options_.shrink == Shrink::kPlugins && names_plugin(failure.who));
    };
    const auto admits = [this](const Case& value) {
      return options_.ground.broken_by(value).empty();
    };
    return intake_.finish({.threads = options_.threads,
                           .shrinks = shrinks,
                           .admits = admits,
                           .seconds_left = [&] { return until - watch_.seconds(); },
                           .methods = options_.methods,
                           .stop = stop_});
  }

  const HuntOptions options_;
  const std::function<void(const HuntProgress&)>& on_progress_;
  const std::atomic<bool>& stop_;
  const Stopwatch watch_;
  Intake intake_;
  HuntReport report_;
  std::vector<Nursery> nurseries_;  ///< one a cell; each is bred by one thread at a time

  std::mutex mutex_;  ///< guards all below, the report and what waits, while threads are at work
  Schedule schedule_;
  double next_sample_ = 0;  ///< the share at which HuntReport::course goes on
  bool met_ = false;        ///< HuntOptions::until
};

}  // namespace

bool breaks_claim(const Failure& failure) {
  return is_false_negative(failure.outcome) && claims_no_false_negative(failure.who);
}

HuntReport hunt(const HuntOptions& options, Store& store,
                const std::function<void(const HuntProgress&)>& on_progress,
                const std::atomic<bool>& stop) {
  CCDFUZZ_VERIFY(!options.methods.empty() && options.threads >= 1 &&
                 options.search.precision == SearchOptions().precision);
  return Hunt(options, store, on_progress, stop).run();
}

}  // namespace ccdfuzz
