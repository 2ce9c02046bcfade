#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "base/enum_names.hpp"

namespace ccdfuzz {

/// Where on each patch the contact lies (Sections 5.2 and 5.3): F interior, E edge, V corner.
enum class ContactClass : std::uint8_t { kFF, kEF, kEE, kVF, kVE, kVV };

constexpr std::array<std::string_view, 6> names_of(ContactClass) {
  return {"FF", "EF", "EE", "VF", "VE", "VV"};
}
inline constexpr auto kContactClasses = all_of(ContactClass{});

/// Section F.1: regular positive and negative, near-hit positive, near-miss negative.
enum class CaseKind : std::uint8_t { kRP, kRN, kNHP, kNMN };

constexpr std::array<std::string_view, 4> names_of(CaseKind) {
  return {"RP", "RN", "NHP", "NMN"};
}
inline constexpr auto kCaseKinds = all_of(CaseKind{});

}  // namespace ccdfuzz
