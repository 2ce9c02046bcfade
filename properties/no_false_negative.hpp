#pragma once

#include <functional>
#include <string>
#include <vector>

#include "ccd/search.hpp"
#include "generators/draw_contact.hpp"
#include "properties/property.hpp"

namespace ccdfuzz {

/// All products of two coordinates and then some stay normal.
inline constexpr ContactRange kOrdinaryRange;
/// Within this scale, products of as many numbers as methods multiply are normal.
inline constexpr int kOrdinaryBits = 100;
/// The products of two coordinates are subnormal or 0.
inline constexpr ContactRange kTiny{-545, -530};
/// The products of two coordinates, or of a few more, are infinite.
inline constexpr ContactRange kHuge{500, 520};
/// Nothing that is drawn under- or overflows a double; products do both. Half of the contacts are
/// in other coordinates.
inline constexpr ContactRange kElsewhere{
    .lowest = -1000, .highest = 900, .max_degree = 5, .elsewhere = true};
/// Coordinates of many bits, and contacts just before or after the times that windows end at.
inline constexpr ContactRange kManyBits{0, 0, 2, 32, true};

/// The options that fuzzing asks with: coarse, and cheap.
inline constexpr SearchOptions kQuickSearch = {0x1p-6, 300, SearchOptions().max_bytes};

/// The method neither says "no contact" (missed) nor names a time after a proven contact (late).
/// Undecided is no failure. Discarded: the truth of the case proves no contact. Shows the case and
/// the answer. Requires a known method spec, and a case whose truth the checker accepts.
void claim_no_false_negative(const std::string& method, const Case& value,
                             const SearchOptions& options, Draw& draw);

/// A case with a witness that the checker accepts, drawn.
using DrawCase = std::function<Case(Draw&)>;
/// draw_contact of a range.
DrawCase contacts_in(const ContactRange& range);
/// An ordinary contact, half of the time after up to four of the mutator's exact moves.
Case draw_transformed(Draw& draw);

/// Checks of that claim on drawn contacts.
std::function<void(Draw&)> misses_nothing(std::string method, DrawCase draw,
                                          SearchOptions options = kQuickSearch);

/// A search drops no pair of boxes that holds the witness of a case, and its window never loses the
/// time of contact. Requires a witness within t_max.
void claim_kept(const std::string& method, const Case& value, Draw& draw,
                double precision = 0x1p-8);
/// Checks of that claim on drawn contacts.
std::function<void(Draw&)> keeps_contacts(std::string method, DrawCase draw);

/// What is claimed of contacts of plain patches, of each method that is proven to miss none:
/// "METHOD.no_false_negative", "METHOD.no_false_negative_linear" by these options and
/// "METHOD.trace".
std::vector<Property> contact_claims(const std::string& method, const std::string& source,
                                     const SearchOptions& of_linear);

/// Appends two claims of a method about contacts that are drawn so: "METHOD.no_false_negativeKIND"
/// and "METHOD.traceKIND", of which kind is "" or "_" and a word. of: what their sentences say
/// after "contact", such as "of rational patches".
void add_contact_claims(std::vector<Property>& claims, const std::string& method,
                        const std::string& kind, const std::string& of, const std::string& source,
                        const DrawCase& draw, Expectation expected = Expectation::kHolds);

}  // namespace ccdfuzz
