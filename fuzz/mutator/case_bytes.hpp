#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "generators/contact.hpp"

namespace ccdfuzz {

/// Which queries are meant: those with velocities that ask for touching, or those with ends, with a
/// separation and with weights, too.
enum class QueryRange : std::uint8_t { kPlain, kAll };

/// A contact and its query as bytes, for fuzzers. First a byte for the method that is to be asked
/// (its place in the target's list), then three for the shape of each patch: kind and degrees. To
/// the kind 4 is added where the patch has ends, 16 where it has weights, 32 where it has a trim,
/// and to the first 8 where there is a separation. Then as doubles, lowest byte first: t_max, the
/// separation if any, t, uv of both contacts, and of each patch the positions, the velocities or
/// ends, and the weights if any; and the trim, the number of its loops, and of each the number of
/// its vertices, as bytes, before them. nullopt if it has more than 255 of these, or if t or a
/// parameter is no double.
std::optional<std::vector<std::uint8_t>> to_bytes(const Contact& q, std::uint8_t method = 0);

/// The method that the bytes are for; 0 if there are none.
std::uint8_t method_number(std::span<const std::uint8_t> bytes);

/// The query that the bytes are; repaired (repair) where they are not a contact any more, as
/// after another's mutations. nullopt if they are no valid query of the
/// range with a contact within t_max.
std::optional<Contact> contact_of_bytes(std::span<const std::uint8_t> bytes,
                                        QueryRange range = QueryRange::kPlain);

/// The query that the bytes are, whatever they say of a contact. nullopt if it is not valid.
std::optional<Query> query_of(std::span<const std::uint8_t> bytes);

/// What fuzz_query and fuzz_witnessed make of the bytes: the query unchanged, without a truth,
/// unless it is the next; and the one whose contact was repaired, with it. None if there is no
/// valid query.
std::vector<Case> cases_of(std::span<const std::uint8_t> bytes);

}  // namespace ccdfuzz
