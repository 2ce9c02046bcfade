#include "query/taxonomy.hpp"

namespace ccdfuzz {

std::string_view name_of(ContactClass c) {
  constexpr std::array<std::string_view, 6> names = {"FF", "EF", "EE", "VF", "VE", "VV"};
  return names.at(static_cast<size_t>(c));
}

std::string_view name_of(CaseKind k) {
  constexpr std::array<std::string_view, 4> names = {"RP", "RN", "NHP", "NMN"};
  return names.at(static_cast<size_t>(k));
}

namespace {

template <class Enum, size_t N>
std::optional<Enum> find_named(const std::array<Enum, N>& all, std::string_view name) {
  for (const Enum e : all) {
    if (name_of(e) == name) return e;
  }
  return std::nullopt;
}

}  // namespace

std::optional<ContactClass> contact_class_named(std::string_view name) {
  return find_named(kContactClasses, name);
}

std::optional<CaseKind> case_kind_named(std::string_view name) {
  return find_named(kCaseKinds, name);
}

}  // namespace ccdfuzz
