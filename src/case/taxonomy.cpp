#include "case/taxonomy.hpp"

namespace ccdfuzz {

std::string_view name_of(ContactClass c) {
  constexpr std::array<std::string_view, 6> names = {"FF", "EF", "EE", "VF", "VE", "VV"};
  return names.at(static_cast<size_t>(c));
}

std::string_view name_of(CaseKind k) {
  constexpr std::array<std::string_view, 4> names = {"RP", "RN", "NHP", "NMN"};
  return names.at(static_cast<size_t>(k));
}

}  // namespace ccdfuzz
