#include "eval/rows.hpp"

#include <algorithm>

#include "base/enum_names.hpp"
#include "case/taxonomy.hpp"

namespace ccdfuzz {

namespace {

/// The paper's classes and kinds in its order, then the rest.
template <class E>
size_t rank_of(const std::string& name) {
  const std::optional<E> known = enum_named<E>(name.substr(0, name.find('+')));
  return known ? static_cast<size_t>(*known) : all_of(E()).size();
}

}  // namespace

std::string kinds_of(const std::string& kind) {
  const std::optional<CaseKind> known = enum_named<CaseKind>(kind);
  if (!known) return kind.empty() ? "-" : kind;
  const bool is_regular = *known == CaseKind::kRP || *known == CaseKind::kRN;
  return std::string(is_regular ? kRegularKinds : kGrazingKinds);
}

Rows::Order Rows::order_of(const RowKey& key) const {
  const auto method = std::ranges::find(methods_, key.method) - methods_.begin();
  return {rank_of<ContactClass>(key.contact),
          key.contact,
          rank_of<CaseKind>(key.kind),
          key.kind,
          key.factor,
          static_cast<size_t>(method)};
}

void Rows::add(const EvaluatedCase& evaluated) {
  for (const GivenAnswer& given : evaluated.answers) {
    if (std::ranges::find(methods_, given.method) == methods_.end()) {
      methods_.push_back(given.method);
    }
    const RowKey key{evaluated.contact, evaluated.kind, given.factor, given.method};
    rows_.try_emplace(order_of(key), Row{key, {}})
        .first->second.tally.add(given.cost, given.outcome, evaluated.collides, given.late_by);
  }
}

std::vector<Row> Rows::in_order(const Coarser& coarser) const {
  std::map<Order, Row> merged;
  for (const auto& [order, row] : rows_) {
    const std::optional<RowKey> key = coarser(row.key);
    if (key) merged.try_emplace(order_of(*key), Row{*key, {}}).first->second.tally.merge(row.tally);
  }
  std::vector<Row> rows;
  for (auto& [order, row] : merged) rows.push_back(std::move(row));
  return rows;
}

std::vector<Row> by_methods(const Rows& rows) {
  return rows.in_order([](const RowKey& key) { return RowKey{"", "", std::nullopt, key.method}; });
}

std::vector<Row> by_kinds(const Rows& rows) {
  return rows.in_order([](RowKey key) {
    key.kind = kinds_of(key.kind);
    return key;
  });
}

}  // namespace ccdfuzz
