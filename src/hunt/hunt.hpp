#pragma once

#include <array>
#include <atomic>
#include <exception>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/enum_names.hpp"
#include "case/taxonomy.hpp"
#include "eval/tally.hpp"
#include "finds/intake.hpp"
#include "hunt/breeder.hpp"
#include "io/fields.hpp"

namespace ccdfuzz {

/// Whose counterexamples a hunt minimises before it ends.
enum class Shrink : std::uint8_t { kNone, kPlugins, kAll };
constexpr std::array<std::string_view, 3> names_of(Shrink) {
  return {"none", "plugins", "all"};
}

struct HuntOptions {
  std::vector<std::string> methods;  ///< parsed specs
  std::uint64_t seed = 1;
  int threads = 1;
  double seconds = 60;
  /// Instead of a time: this many draws of each class, every one put to every method, and mutants
  /// in proportion. Then the hunt depends on nothing but these options, and finds the same things
  /// in every run.
  std::optional<std::uint64_t> cases;
  HuntGround ground;
  /// Ends once a counterexample with this outcome is met, and is shrunk then.
  std::optional<Outcome> until;
  Shrink shrink = Shrink::kPlugins;
  /// A built-in method that is timed on the same draws.
  std::optional<std::string> beside;
  /// Budgets of a query; the precision is the default one, since replay asks at that.
  SearchOptions search;
};

/// The results of one method on one contact class.
struct HuntCell {
  std::string method;
  ContactClass contact = ContactClass::kFF;
  Tally tally;          ///< for the draws
  BreedTally bred;      ///< for their mutants
  LogHistogram beside;  ///< seconds of HuntOptions::beside for the draws that it answers, too

  static void fields(auto& archive, auto& cell) {
    archive.constant("row", "cell");
    archive("class", cell.contact);
    archive("method", cell.method);
    Tally::fields(archive, cell.tally);
    archive("mutants", cell.bred.mutants);
    archive("lost_mutants", cell.bred.lost);
    archive("margin_ulps", cell.bred.margin);
    archive("mean_seconds", cell.tally.seconds.mean());
    archive("p999_seconds", cell.tally.seconds.quantile(0.999));
    if (cell.beside.count() == 0) return;
    archive("beside_mean_seconds", cell.beside.mean());
    archive("beside_p999_seconds", cell.beside.quantile(0.999));
  }
};

/// True iff it is a false negative of a method that claims to have none.
bool breaks_claim(const Failure& failure);

/// A moment of a hunt: what there was until then.
struct HuntSample {
  double seconds = 0;
  std::uint64_t queries = 0;  ///< answered and judged
  std::uint64_t mutants = 0;  ///< bred
  std::uint64_t finds = 0;
  /// For each of HuntOptions::methods the least number of ulps by which a contact survived its
  /// tests (BreedTally::margin); nothing while none was traced.
  std::vector<std::optional<std::uint64_t>> margins;
};

struct HuntReport {
  std::vector<HuntCell> cells;  ///< class by class, within it method by method
  std::vector<Find> finds;      ///< one for every failure that was met, known ones among them
  /// At every 1/200 of the hunt and at its end, which comes last. By cases all but the seconds
  /// repeats exactly.
  std::vector<HuntSample> course;
  std::uint64_t cases = 0;  ///< draws of each class, of the method that had most
  double seconds = 0;
  double draw_cpu_seconds = 0;  ///< spent on making cases
  /// The store cannot be read or written at the end of the hunt. finds then holds all the same what
  /// could not be stored.
  std::optional<InputError> error;
  /// The NoProcess that ended the hunt early, with what it has; null: none did.
  std::exception_ptr refused;
};

/// The progress of a hunt.
struct HuntProgress : HuntSample {
  double share = 0;  ///< 1 at its end, with all that was found
  /// The first error of the store, if there was one. The hunt continues: it keeps its finds
  /// in memory and stores them as soon as it can.
  std::optional<InputError> trouble;
  std::vector<Failure> met;  ///< that this hunt meets first, since the last call
};

/// Searches for failures of methods and stores the smallest find of each Failure. Draws cases of
/// each contact class that has some, runs the methods on them, judges, and breeds mutants that a
/// method nearly loses (Breeder). By time, each cell of a class and a method gets an equal share of
/// CPU time, half of it for mutants (Schedule). stop ends the hunt early, with what it has.
/// Requires at least one method.
HuntReport hunt(const HuntOptions& options, Store& store,
                const std::function<void(const HuntProgress&)>& on_progress,
                const std::atomic<bool>& stop);

}  // namespace ccdfuzz
