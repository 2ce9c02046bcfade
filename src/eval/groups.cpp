#include "eval/groups.hpp"

#include <algorithm>

#include "base/enum_names.hpp"
#include "case/taxonomy.hpp"

namespace ccdfuzz {

namespace {

/// The paper's classes in its order, then the rest.
size_t rank_of_class(const std::string& contact) {
  const std::optional<ContactClass> known = enum_named<ContactClass>(contact);
  return known ? static_cast<size_t>(*known) : kContactClasses.size();
}

size_t rank_of_kinds(const std::string& kinds) {
  return kinds == "RP+RN" ? 0 : kinds == "NHP+NMN" ? 1 : 2;
}

}  // namespace

std::string kinds_of(const std::string& kind) {
  const std::optional<CaseKind> known = enum_named<CaseKind>(kind);
  if (!known) return kind.empty() ? "-" : kind;
  return *known == CaseKind::kRP || *known == CaseKind::kRN ? "RP+RN" : "NHP+NMN";
}

void EvaluatedGroup::add(const GivenAnswer& given, std::optional<bool> collides) {
  Answer answer;
  answer.pops = given.pops;
  answer.seconds = given.seconds;
  tally.add(answer, given.outcome, collides);
  if (given.outcome == Outcome::kNotAsked) return;
  seconds.add(given.seconds);
  bytes.add(static_cast<double>(given.bytes));
}

void EvaluatedGroup::merge(const EvaluatedGroup& other) {
  tally.merge(other.tally);
  seconds.append(other.seconds);
  bytes.append(other.bytes);
}

void Groups::add(const EvaluatedCase& evaluated) {
  const std::string kinds = kinds_of(evaluated.kind);
  for (const GivenAnswer& answer : evaluated.answers) {
    const auto known = std::ranges::find(methods_, answer.method);
    const auto method = static_cast<size_t>(known - methods_.begin());
    if (known == methods_.end()) methods_.push_back(answer.method);
    EvaluatedGroup& group = groups_[{rank_of_class(evaluated.contact), evaluated.contact,
                                     rank_of_kinds(kinds), kinds, answer.factor, method}];
    group.contact = evaluated.contact;
    group.kinds = kinds;
    group.factor = answer.factor;
    group.method = answer.method;
    group.add(answer, evaluated.collides);
  }
}

std::vector<EvaluatedGroup> Groups::in_order() const {
  std::vector<EvaluatedGroup> ordered;
  ordered.reserve(groups_.size());
  for (const auto& [key, group] : groups_) ordered.push_back(group);
  return ordered;
}

std::vector<EvaluatedGroup> at_contact(const std::vector<EvaluatedGroup>& groups,
                                       const std::optional<std::string>& kinds) {
  std::vector<EvaluatedGroup> merged;
  for (const EvaluatedGroup& group : groups) {
    if ((group.factor && *group.factor != 1) || (kinds && group.kinds != *kinds)) continue;
    const auto same = std::ranges::find_if(merged, [&](const EvaluatedGroup& m) {
      return m.contact == group.contact && m.method == group.method;
    });
    if (same != merged.end()) {
      same->merge(group);
      continue;
    }
    // The same class stays together: with horizons a method may come first in a later group.
    auto place = std::ranges::find_if(
        merged, [&](const EvaluatedGroup& m) { return m.contact == group.contact; });
    while (place != merged.end() && place->contact == group.contact) ++place;
    merged.insert(place, group);
  }
  return merged;
}

}  // namespace ccdfuzz
