#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "eval/evaluated_case.hpp"
#include "eval/tally.hpp"

namespace ccdfuzz {

/// The halves of Table 2.
inline constexpr std::string_view kRegularKinds = "RP+RN", kGrazingKinds = "NHP+NMN";

/// "RP+RN" for the regular kinds, "NHP+NMN" for the grazing ones, as the halves of Table 2; any
/// other kind by itself, and "-" for none.
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
    const Tally& tally = row.tally;
    archive("class", row.key.contact);
    archive("kinds", row.key.kind);
    archive("t_max_factor", row.key.factor);
    archive("method", row.key.method);
    Tally::fields(archive, tally);
    const auto n = static_cast<double>(tally.n);
    archive("mean_pops", tally.n == 0 ? 0.0 : static_cast<double>(tally.pops) / n);
    archive("mean_bytes", tally.bytes.mean());
    archive("median_bytes", tally.bytes.median());
    archive("p99_bytes", tally.bytes.p99());
    archive("max_bytes", tally.bytes.largest());
    archive("mean_seconds", tally.seconds.mean());
    archive("median_seconds", tally.seconds.median());
    archive("p99_seconds", tally.seconds.p99());
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
  /// ones first; horizons; methods as they first came.
  std::vector<Row> in_order() const;
  /// The same of coarser rows: those that `coarser` gives the same key are one, and those that it
  /// gives none are left out. It keeps the method.
  std::vector<Row> in_order(
      const std::function<std::optional<RowKey>(const RowKey&)>& coarser) const;

 private:
  struct Order {
    size_t contact_rank;
    std::string contact;
    size_t kind_rank;
    std::string kind;
    std::optional<double> factor;
    size_t method;
    auto operator<=>(const Order&) const = default;
  };
  Order order_of(const RowKey& key) const;

  std::vector<std::string> methods_;
  std::map<Order, Row> rows_;
};

/// One row for each method, over all queries.
std::vector<Row> by_methods(const Rows& rows);

/// The rows of an evaluation with the kinds of kinds_of together, as tables show them.
std::vector<Row> by_kinds(const Rows& rows);

}  // namespace ccdfuzz
