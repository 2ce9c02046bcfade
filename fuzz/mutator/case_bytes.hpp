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

/// A contact and its query as bytes, for fuzzers, in this order. Doubles have their lowest byte
/// first.
/// 1. A byte for the method that is to be asked: its place in the target's list.
/// 2. For each patch three bytes, its kind and its degrees. The kind has 4 added if the patch has
///    ends, 16 if it has weights, 32 if it has a trim. The first one has 8 added if there is a
///    separation.
/// 3. As doubles t_max, the separation if any, t, and uv of both contacts.
/// 4. For each patch its positions, its velocities or ends, and its weights if any, as doubles.
///    Its trim follows if any: bytes for the number of loops and for the number of vertices of
///    each loop, then the vertices as doubles.
/// nullopt if a trim has more than 255 loops or a loop that many vertices, or if t or a parameter
/// is no double.
std::optional<std::vector<std::uint8_t>> to_bytes(const Contact& q, std::uint8_t method = 0);

/// The method that the bytes are for; 0 if there are none.
std::uint8_t method_number(std::span<const std::uint8_t> bytes);

/// The query that the bytes are. It is repaired (repair) where they are not a contact any more, as
/// after another's mutations. nullopt if they are no valid query of the range with a contact within
/// t_max.
std::optional<Contact> contact_of_bytes(std::span<const std::uint8_t> bytes,
                                        QueryRange range = QueryRange::kPlain);

/// The query that the bytes are, whatever they say of a contact. nullopt if it is not valid.
std::optional<Query> query_of(std::span<const std::uint8_t> bytes);

/// What fuzz_query and fuzz_witnessed make of the bytes: the query unchanged, without a truth, and
/// the query whose contact was repaired, with it. One if both are the same, none if there is no
/// valid query.
std::vector<Case> cases_of(std::span<const std::uint8_t> bytes);

}  // namespace ccdfuzz
