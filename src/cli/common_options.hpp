#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "base/result.hpp"
#include "base/shard.hpp"
#include "bezier/shape.hpp"
#include "ccd/search.hpp"
#include "cli/command.hpp"
#include "files/case_files.hpp"
#include "io/table.hpp"

namespace ccdfuzz {

/// The methods that answer every case in seconds. `trad` is not one: it takes minutes where patches
/// are nearly parallel. It runs where it is named or its budget is small.
std::vector<std::string> default_methods();

/// --precision, --max-pops and --max-seconds, the limits of one query.
struct SearchFlags {
  std::optional<double> precision;  ///< absent: 1e-4, or what the case says (asked)
  /// Absent: as many, within a DefaultBudget.
  std::optional<std::uint64_t> max_pops = SearchOptions().max_pops;
  double max_seconds = SearchOptions::kNoTimeLimit;

  std::vector<Option> add_to(Command& command);
  Option add_precision_to(Command& command);
  /// Without --precision.
  std::vector<Option> add_budget_to(Command& command);
  SearchOptions options() const;
  /// The same for one case, which may say how it is to be asked. times: as for DefaultBudget.
  SearchOptions options_for(const Case& value, std::uint64_t times = 1) const;
};

/// The plug-ins of expectations that were not allowed, and how many expectations each has.
using NotAllowed = std::map<std::string, std::uint64_t>;

/// "3 expectations of plug-ins not run: allow them with --allow-plugins A,B". Requires not empty.
std::string to_text(const NotAllowed& left_out);

/// --plugin, and --methods: of these the command asks, in this order.
std::vector<Option> add_methods(Command& command, std::vector<std::string>& methods,
                                const std::string& description);

/// " OPTION VALUE,VALUE", for a shell; empty without values.
std::string option_words(const char* name, const std::vector<std::string>& values);
/// --plugin for those that have a name; with --methods for all.
std::string plugin_words(const std::vector<std::string>& methods);
std::string method_words(const std::vector<std::string>& methods);

/// The method as tables show it: " *" follows where it claims to have no false negative.
std::string marked(const std::string& method);
/// A note that explains " *"; empty if none of the methods has it.
std::string mark_note(const std::vector<std::string>& methods);
/// A column for marked().
Table::Column method_column();
/// "1 case", "2 cases".
std::string counted(std::uint64_t count, const char* one, const char* many);

/// --shard, by default the complete run.
Option add_shard(Command& command, std::string& shard);
/// "i/n", of at most `total` shards, so that none is empty. Errors: anything else.
Result<Shard> parse_shard(const std::string& text, std::uint64_t total, const char* what);

/// Reads one shape for both patches, or one for each with a comma between: "point", "curve:N",
/// "triangle:N", "tensor:NxM", degrees 1 to kMaxDegree. Errors: anything else, naming `where`.
Result<std::array<Shape, 2>> parse_shapes(const std::string& where, const std::string& text);

/// Counts of the cases that a command was given.
struct CaseCount {
  std::uint64_t cases = 0;
  /// Cases whose absence of contact, up to t_max or else up to clear_until, has no proof but the
  /// word of a method. Nothing is judged by it.
  std::uint64_t by_word = 0;
  /// With a truth and a label of a query CSV; of them, those whose label says otherwise.
  std::uint64_t labels = 0, wrong_labels = 0;

  void add(const Case& value);
  /// Says on stderr what is not as it should be.
  void note(Session& session) const;
};

}  // namespace ccdfuzz
