// What guides a hunt, from nothing, in CPU seconds of one thread. It measures how soon a method's
// first false negative is found, or how many contacts (--losses) or kinds of contacts (--kinds) it
// loses on the way. Three ways are compared: draws alone; breeding them without a look at the
// margins of the witness trace; breeding half from those with small margins. Medians over seeds; a
// run that found nothing counts as longer than any.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <iostream>
#include <limits>
#include <set>
#include <vector>

#include "bench/median.hpp"
#include "ccd/witness_trace/loss_signature.hpp"
#include "hunt/breeder.hpp"
#include "hunt/draw.hpp"
#include "hunt/schedule.hpp"
#include "io/cpu_time.hpp"

namespace ccdfuzz {
namespace {

enum class Strategy : std::uint8_t { kDraws, kDrift, kMargins };
constexpr std::array kStrategies = {Strategy::kDraws, Strategy::kDrift, Strategy::kMargins};

/// What is looked for.
struct Quarry {
  std::string method;
  std::vector<ContactClass> classes;
  HuntGround ground;
  std::string name;
};

std::vector<ContactClass> all_classes() {
  return {kContactClasses.begin(), kContactClasses.end()};
}

/// What loses contacts.
constexpr std::array kMethods = {
    "tdibm",           "tdibm-h:1e-16", "tdibm-h:1e-12", "tdibm-h:1e-12@absolute",
    "tdibm-e-literal", "tdibm-e",       "trad"};

std::vector<Quarry> quarries() {
  std::vector<Quarry> all;
  for (const char* method : kMethods) {
    all.push_back({method, all_classes(), {}, method});
  }
  // Rarer ones: inside of patches, and where nothing under- or overflows.
  constexpr int kOrdinary = 40;
  HuntGround ordinary;
  ordinary.scale = kOrdinary;
  for (const char* method : kMethods) {
    all.push_back({method,
                   {ContactClass::kFF, ContactClass::kEF},
                   ordinary,
                   fmt::format("{}, FF and EF within 2^±{}", method, kOrdinary)});
  }
  return all;
}

/// Those of this name, or of none such those whose name begins so.
std::vector<Quarry> quarries_named(const std::string& name) {
  std::vector<Quarry> exact, beginning;
  for (const Quarry& quarry : quarries()) {
    if (quarry.name == name) exact.push_back(quarry);
    if (quarry.name.starts_with(name)) beginning.push_back(quarry);
  }
  return exact.empty() ? beginning : exact;
}

constexpr double kNever = std::numeric_limits<double>::infinity();

/// One run: the same draws whatever the search, an equal share of time for each class, and half of
/// it for mutants.
class Run {
 public:
  Run(const Quarry& quarry, Strategy search, std::uint64_t seed)
      : quarry_(quarry), search_(search), draws_(seed, quarry.ground) {
    for (const ContactClass contact : quarry.classes) {
      const Aim aim = search == Strategy::kMargins ? Aim::kMargins : Aim::kNothing;
      cells_.push_back({contact, Breeder(quarry.method, seed, quarry.ground, aim), 0});
    }
    for (Cell& cell : cells_) {
      cell.breeder.watch_losses(
          [this](const Contact& q, const Trace& trace) { note_kind(q, trace); });
    }
  }

  /// CPU seconds until the first false negative; kNever if that is more than `most`.
  double seconds_to_first(double most) {
    asks_ = true;
    return seconds_used(most);
  }

  /// Draws that the method's trace loses in so much time; of the other searches mutants of the
  /// first kFounders draws of each class. No query is asked.
  double losses_in(double seconds) {
    seconds_used(seconds);
    double all = search_ == Strategy::kDraws ? static_cast<double>(lost_draws_) : 0;
    for (const Cell& cell : cells_) all += static_cast<double>(cell.breeder.tally().lost);
    return all;
  }

  /// How many kinds of contacts the method's trace loses in so much time. Kinds differ in class,
  /// level, axis or wrong quantity, as fuzz_witnessed tells them apart.
  double kinds_in(double seconds) {
    seconds_used(seconds);
    return static_cast<double>(kinds_.size());
  }

  Run(const Run&) = delete;
  Run& operator=(const Run&) = delete;

 private:
  static constexpr std::uint64_t kFounders = 3;

  struct Cell {
    ContactClass contact;
    Breeder breeder;
    std::uint64_t next_draw;
  };

  double seconds_used(double most) {
    const double start = thread_cpu_seconds();
    Schedule schedule(cells_.size());
    while (!found_ && thread_cpu_seconds() - start < most) {
      const Turn turn = *schedule.next();
      const double begin = thread_cpu_seconds();
      take_turn(turn.what, cells_[turn.cell]);
      schedule.done(turn, thread_cpu_seconds() - begin);
    }
    return found_ ? thread_cpu_seconds() - start : kNever;
  }

  void take_turn(Turn::What what, Cell& cell) {
    const bool breeds = asks_ ? what == Turn::What::kBreed : cell.next_draw == kFounders;
    if (search_ != Strategy::kDraws && breeds) {
      constexpr double kSlice = 0.02;
      const double begin = thread_cpu_seconds();
      while (!found_ && thread_cpu_seconds() - begin < kSlice) {
        cell.breeder.step(methods_, budget(),
                          [&](const Case&, const Judged& judged) { note(judged); });
      }
      return;
    }
    bool lost = false;  // the same contact, up to it and past it
    for (const CheckedCase& known : draws_.at(cell.contact, cell.next_draw++)) {
      const Case& asked = known.value();
      if (asks_) {
        note(ask(methods_[quarry_.method], known, budget()));
      } else {
        lost = lost || loses(asked);
      }
      if (found_) return;
      if (search_ != Strategy::kDraws) cell.breeder.add(asked, methods_);
    }
    lost_draws_ += lost ? 1 : 0;
  }

  SearchOptions budget() const {
    SearchOptions search;
    search.max_pops = asks_ ? 10'000 : 0;
    return search;
  }

  bool loses(const Case& asked) {
    const std::optional<Witness>& witness = asked.truth.witness;
    if (!witness || witness->t > exact(asked.query.t_max)) return false;
    const Trace& trace = methods_[quarry_.method].trace(asked.query, *witness, {});
    if (!trace.lost) return false;
    if (const auto q = contact_of(asked)) note_kind(*q, trace);
    return true;
  }

  void note_kind(const Contact& q, const Trace& trace) {
    kinds_.insert(fmt::format("{} {}", name_of(contact_class_of(q)), loss_signature(trace)));
  }

  void note(const Judged& judged) {
    found_ = found_ || (asks_ && is_false_negative(judged.outcome));
  }

  const Quarry& quarry_;
  Strategy search_;
  Draws draws_;
  MethodSet methods_;
  std::vector<Cell> cells_;
  bool asks_ = false, found_ = false;
  std::uint64_t lost_draws_ = 0;
  std::set<std::string> kinds_;
};

std::string seconds_text(const std::vector<double>& seconds, double most) {
  const auto found = std::ranges::count_if(seconds, [](double s) { return s < kNever; });
  const double middle = median(seconds);
  const std::string text =
      middle < kNever ? fmt::format("{:.3g} s", middle) : fmt::format("> {:g} s", most);
  const bool all = static_cast<std::size_t>(found) == seconds.size();
  return all ? text : fmt::format("{} ({} of {})", text, found, seconds.size());
}

}  // namespace
}  // namespace ccdfuzz

int main(int argc, char** argv) {
  using namespace ccdfuzz;  // NOLINT: the program's own
  CLI::App app{"How soon and how often contacts are lost, from nothing; medians over seeds."};
  std::uint64_t seeds = 5;
  double most = 60;
  std::string only;
  bool losses = false, kinds = false;
  app.add_option("--seeds", seeds, "Runs of each search")->check(CLI::PositiveNumber);
  app.add_option("--seconds", most, "CPU seconds after which a run ends")
      ->check(CLI::PositiveNumber);
  app.add_option("--only", only, "The row of this name, or the rows whose names begin so")
      ->check([](const std::string& name) -> std::string {
        return quarries_named(name).empty() ? "no row begins with " + name : "";
      });
  app.add_flag("--losses", losses, "Count the contacts lost in all that time, asking no query");
  app.add_flag("--kinds", kinds, "Count the kinds of them")->excludes("--losses");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }
  fmt::print("| {} | draws | bred, margins unseen | bred by margins, too |\n",
             losses  ? fmt::format("contacts lost in {:g} s by", most)
             : kinds ? fmt::format("kinds of contacts lost in {:g} s by", most)
                     : "first false negative of");
  fmt::print("|---|---|---|---|\n");
  for (const Quarry& quarry : quarries_named(only)) {
    fmt::print("| {} |", quarry.name);
    for (const Strategy search : kStrategies) {
      std::vector<double> values;
      for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
        Run run(quarry, search, seed);
        values.push_back(losses  ? run.losses_in(most)
                         : kinds ? run.kinds_in(most)
                                 : run.seconds_to_first(most));
      }
      fmt::print(" {} |", losses || kinds ? fmt::format("{:g}", median(values))
                                          : seconds_text(values, most));
      std::cout.flush();
    }
    fmt::print("\n");
  }
}
