#pragma once

#include <string>

#include "ccd/search.hpp"
#include "generators/draw_contact.hpp"
#include "properties/property.hpp"

namespace ccdfuzz {

/// The method neither says "no contact" (missed) nor names a time after a proven contact (late).
/// Undecided is no failure. Discarded: the truth of the case proves no contact.
/// Requires a known method spec, and a case whose truth the checker accepts.
Check no_false_negative(const std::string& method, const Case& value, const SearchOptions& options);

/// What fuzzing asks with: coarse, and cheap.
inline constexpr SearchOptions kQuickSearch = {0x1p-6, 300, SearchOptions().max_bytes};

/// On drawn contacts.
Check check_no_false_negative(const std::string& method, const ContactRange& range, Draw& choices,
                              const SearchOptions& options = kQuickSearch);

}  // namespace ccdfuzz
