#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "case/answer.hpp"
#include "case/outcome.hpp"
#include "eval/tally.hpp"

namespace ccdfuzz {

/// A method's answer to a case, up to one time.
struct GivenAnswer {
  std::optional<double> factor;  ///< t_max by the contact's time; absent where asked unchanged
  std::string method;
  double t_max = 0;
  Verdict verdict = Verdict::kUndecided;
  std::optional<double> toi;  ///< absent after a miss
  Outcome outcome = Outcome::kUnknown;
  double late_by = 0;  ///< as of Judged
  Cost cost;

  static void fields(auto& archive, auto& answer) {
    archive("t_max_factor", answer.factor);
    archive("method", answer.method);
    archive("t_max", answer.t_max);
    archive("verdict", answer.verdict);
    archive("toi", answer.toi);
    archive("outcome", answer.outcome);
    archive.optional("late_by", answer.late_by);
    Cost::fields(archive, answer.cost);
  }

  friend bool operator==(const GivenAnswer&, const GivenAnswer&) = default;
};

/// A case of an evaluation with all answers to it: a line of answers.jsonl, of which all tables are
/// made.
struct EvaluatedCase {
  std::uint64_t index = 0;  ///< the case's in the data set, from 0
  std::string id;           ///< file and line
  std::string contact;      ///< "-" if the case does not say
  std::string kind;
  std::optional<bool> collides;  ///< the truth
  std::vector<GivenAnswer> answers;

  static void fields(auto& archive, auto& evaluated) {
    archive("index", evaluated.index);
    archive("case", evaluated.id);
    archive("class", evaluated.contact);
    archive("kind", evaluated.kind);
    archive("collides", evaluated.collides);
    archive("answers", evaluated.answers);
  }

  friend bool operator==(const EvaluatedCase&, const EvaluatedCase&) = default;
};

/// The halves of Table 2.
inline constexpr std::string_view kRegularKinds = "RP+RN", kGrazingKinds = "NHP+NMN";

/// The half of Table 2 that a kind is of; any other kind by itself, and "-" for none.
std::string kinds_of(const std::string& kind);

/// The common properties of a row's answers.
struct RowKey {
  std::string contact;  ///< "-" if the case does not say
  std::string kind;     ///< one kind, or several that are taken together; empty if unknown
  std::optional<double> factor;
  std::string method;
};

/// All answers of one method to queries of one sort: what every table and figure is made of.
struct Row {
  RowKey key;
  Tally tally;

  static void fields(auto& archive, auto& row) {
    archive("class", row.key.contact);
    archive("kinds", row.key.kind);
    archive("t_max_factor", row.key.factor);
    archive("method", row.key.method);
    Tally::fields(archive, row.tally);
    Tally::measures(archive, row.tally);
  }
};

/// True iff a table shows the two without a blank line between them.
inline bool are_beside(const Row& a, const Row& b) {
  return a.key.contact == b.key.contact && a.key.kind == b.key.kind && a.key.factor == b.key.factor;
}

/// The answers of an evaluation, summed up.
class Rows {
 public:
  void add(const EvaluatedCase& evaluated);

  /// The rows in the order: contact classes of the paper, then others by name; kinds, the regular
  /// ones first; horizons; methods as they first came. Those that `coarser` gives the same key are
  /// one, and those that it gives none are left out. It keeps the method.
  using Coarser = std::function<std::optional<RowKey>(const RowKey&)>;
  std::vector<Row> in_order(const Coarser& coarser = std::identity()) const;

 private:
  /// Rank and name of the class, of the kind; factor; place of the method.
  using Order = std::tuple<size_t, std::string, size_t, std::string, std::optional<double>, size_t>;
  Order order_of(const RowKey& key) const;

  std::vector<std::string> methods_;
  std::map<Order, Row> rows_;
};

/// One row for each method, over all queries.
std::vector<Row> by_methods(const Rows& rows);

/// The rows of an evaluation with the kinds of kinds_of together, as tables show them.
std::vector<Row> by_kinds(const Rows& rows);

}  // namespace ccdfuzz
