#pragma once

#include <array>

#include "properties/property.hpp"

namespace ccdfuzz {

/// The letters of the certificates that hold_certificates draws: of contacts and of absences.
inline constexpr std::string_view kDrawnCertificates = "WMRPTL";
/// Which of them the checker accepted.
using AcceptedCertificates = std::array<bool, kDrawnCertificates.size()>;

/// Draws a query whose contact is known, and certificates for it, most of them false. Holds what
/// the checker accepts to each other: a proof of absence never covers a contact. Nothing else of
/// the project is needed but the checker and what is drawn, so that it is tested alone.
AcceptedCertificates hold_certificates(Draw& d);

std::vector<Property> checker_alone_claims();

}  // namespace ccdfuzz
