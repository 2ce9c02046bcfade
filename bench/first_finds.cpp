// How soon a method's first false negative is found, from nothing: in CPU seconds of one thread, by
// draws alone, by breeding them without a look at the margins of the witness trace, and by breeding
// every other one from those with small margins. Medians over seeds; a run that found nothing
// counts as longer than any.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <iostream>
#include <limits>
#include <vector>

#include "eval/cpu_time.hpp"
#include "hunt/breeder.hpp"
#include "hunt/draw.hpp"
#include "hunt/scheduler.hpp"

namespace ccdfuzz {
namespace {

enum class Strategy : std::uint8_t { kDraws, kDrift, kMargins };
constexpr std::array kStrategies = {Strategy::kDraws, Strategy::kDrift, Strategy::kMargins};

/// What is looked for.
struct Quarry {
  std::string method;
  std::vector<ContactClass> classes;
  std::optional<int> scale;  ///< as in HuntOptions
  std::string name;
};

std::vector<ContactClass> all_classes() {
  return {kContactClasses.begin(), kContactClasses.end()};
}

std::vector<Quarry> quarries() {
  std::vector<Quarry> all;
  for (const char* method :
       {"tdibm", "tdibm-h:1e-16", "tdibm-h-rel:1e-12", "tdibm-e-literal", "tdibm-e"}) {
    all.push_back({method, all_classes(), std::nullopt, method});
  }
  // Rarer ones: inside of patches, and where nothing under- or overflows.
  constexpr int kOrdinary = 40;
  for (const char* method : {"tdibm", "tdibm-h:1e-16", "tdibm-h-rel:1e-12", "tdibm-e-literal"}) {
    all.push_back({method,
                   {ContactClass::kFF, ContactClass::kEF},
                   kOrdinary,
                   fmt::format("{}, FF and EF within 2^±{}", method, kOrdinary)});
  }
  return all;
}

constexpr double kNever = std::numeric_limits<double>::infinity();

/// One run: the same draws whatever the search, an equal share of time for each class, and half of
/// it for mutants.
class Run {
 public:
  Run(const Quarry& quarry, Strategy search, std::uint64_t seed)
      : quarry_(quarry), search_(search) {
    for (const ContactClass contact : quarry.classes) {
      const Aim aim = search == Strategy::kMargins ? Aim::kMargins : Aim::kNothing;
      cells_.push_back({contact, Breeder(quarry.method, seed, quarry.scale, aim), 0, 0, 0});
    }
    seed_ = seed;
  }

  /// CPU seconds until the first false negative; kNever if that is more than `most`.
  double seconds_to_first(double most) {
    const double start = thread_cpu_seconds();
    Scheduler scheduler(cells_.size());
    while (!found_ && thread_cpu_seconds() - start < most) {
      const std::size_t turn = scheduler.begin();
      const double begin = thread_cpu_seconds();
      take_turn(cells_[cells_.size() - 1 - turn]);
      scheduler.end(turn, thread_cpu_seconds() - begin);
    }
    return found_ ? thread_cpu_seconds() - start : kNever;
  }

 private:
  struct Cell {
    ContactClass contact;
    Breeder breeder;
    std::uint64_t next_draw;
    double drawn_seconds, bred_seconds;
  };

  void take_turn(Cell& cell) {
    const double begin = thread_cpu_seconds();
    const auto used = [&] { return thread_cpu_seconds() - begin; };
    if (search_ != Strategy::kDraws && cell.bred_seconds < cell.drawn_seconds) {
      constexpr double kSlice = 0.02;
      while (!found_ && used() < kSlice) {
        cell.breeder.step(methods_, tracers_, budget(),
                          [&](const Case&, const Judged& judged) { note(judged); });
      }
      cell.bred_seconds += used();
      return;
    }
    for (const Case& asked : draw(cell.contact, seed_, cell.next_draw++, quarry_.scale).asked) {
      note(ask(methods_[quarry_.method], asked, budget()));
      if (found_) return;
      if (search_ != Strategy::kDraws) cell.breeder.add(asked, tracers_);
    }
    cell.drawn_seconds += used();
  }

  static SearchOptions budget() {
    SearchOptions search;
    search.max_pops = 10'000;
    return search;
  }

  void note(const Judged& judged) { found_ = found_ || is_false_negative(judged.outcome); }

  const Quarry& quarry_;
  Strategy search_;
  std::uint64_t seed_ = 0;
  MethodSet methods_;
  TracerSet tracers_;
  std::vector<Cell> cells_;
  bool found_ = false;
};

std::string median_text(std::vector<double> seconds, double most) {
  std::ranges::sort(seconds);
  const auto found = std::ranges::count_if(seconds, [](double s) { return s < kNever; });
  const double median = seconds[seconds.size() / 2];
  const std::string text =
      median < kNever ? fmt::format("{:.3g} s", median) : fmt::format("> {:g} s", most);
  const bool all = static_cast<std::size_t>(found) == seconds.size();
  return all ? text : fmt::format("{} ({} of {})", text, found, seconds.size());
}

}  // namespace
}  // namespace ccdfuzz

int main(int argc, char** argv) {
  using namespace ccdfuzz;  // NOLINT: the program's own
  CLI::App app{"Times to the first false negative, from nothing; medians over seeds."};
  std::uint64_t seeds = 5;
  double most = 60;
  std::string only;
  app.add_option("--seeds", seeds, "Runs of each search")->check(CLI::PositiveNumber);
  app.add_option("--seconds", most, "CPU seconds after which a run ends");
  app.add_option("--only", only, "Rows whose name begins so");
  CLI11_PARSE(app, argc, argv);
  fmt::print("| first false negative of | draws | bred, margins unseen | bred by margins, too |\n");
  fmt::print("|---|---|---|---|\n");
  for (const Quarry& quarry : quarries()) {
    if (!quarry.name.starts_with(only)) continue;
    fmt::print("| {} |", quarry.name);
    for (const Strategy search : kStrategies) {
      std::vector<double> seconds;
      for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
        seconds.push_back(Run(quarry, search, seed).seconds_to_first(most));
      }
      fmt::print(" {} |", median_text(std::move(seconds), most));
      std::cout.flush();
    }
    fmt::print("\n");
  }
}
