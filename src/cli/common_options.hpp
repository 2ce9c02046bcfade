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
#include "finds/claim_find.hpp"
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

/// The command that runs a property on what follows: choices, or one draw. method: that of a claim
/// about() one; otherwise empty.
std::string check_command(const std::string& property, const std::string& method,
                          const std::string& on);
/// The options that are these choices, or one draw.
std::string words_of(const ChoiceNumbers& choices);
std::string words_of(std::uint64_t seed, std::uint64_t index);

/// One command that shows what a find was shrunk to, or what failed first.
std::string reproduction(const ClaimFind& find);

/// --shard, by default the complete run.
Option add_shard(Command& command, std::string& shard);
/// "i/n", of at most `total` shards, so that none is empty. Errors: anything else.
Result<Shard> parse_shard(const std::string& text, std::uint64_t total, const char* what);

/// Throws BadInput, naming the option, if the output is one of the inputs, which are `what`: it
/// would be lost.
void refuse_input(const char* option, const std::string& output,
                  const std::vector<std::string>& inputs, const char* what);

/// Reads one shape for both patches, or one for each with a comma between: "point", "curve:N",
/// "triangle:N", "tensor:NxM", degrees 1 to kMaxDegree. Errors: anything else, naming `where`.
Result<std::array<Shape, 2>> parse_shapes(const std::string& where, const std::string& text);

}  // namespace ccdfuzz
