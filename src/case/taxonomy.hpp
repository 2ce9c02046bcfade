#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

namespace ccdfuzz {

/// Where on each patch the contact lies (Sections 5.2 and 5.3): F interior, E edge, V corner.
enum class ContactClass : std::uint8_t { kFF, kEF, kEE, kVF, kVE, kVV };

inline constexpr std::array kContactClasses = {ContactClass::kFF, ContactClass::kEF,
                                               ContactClass::kEE, ContactClass::kVF,
                                               ContactClass::kVE, ContactClass::kVV};

/// Section F.1: regular positive and negative, near-hit positive, near-miss negative.
enum class CaseKind : std::uint8_t { kRP, kRN, kNHP, kNMN };

inline constexpr std::array kCaseKinds = {CaseKind::kRP, CaseKind::kRN, CaseKind::kNHP,
                                          CaseKind::kNMN};

std::string_view name_of(ContactClass c);  ///< "FF", …
std::string_view name_of(CaseKind k);      ///< "RP", …
constexpr const auto& all_of(ContactClass) {
  return kContactClasses;
}
constexpr const auto& all_of(CaseKind) {
  return kCaseKinds;
}

}  // namespace ccdfuzz
