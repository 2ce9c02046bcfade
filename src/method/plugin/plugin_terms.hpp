#pragma once

#include <optional>

#include "method/method.hpp"
#include "method/plugin/line_protocol.hpp"

namespace ccdfuzz {

/// How an answer of a plug-in is judged: as it claims, or more strictly where the answer has
/// achieved a tighter tolerance; never more loosely.
AnswerTerms terms_of(const PluginDescription& claims, const PluginAnswer& given,
                     const Query& query);

/// "broken claim" where the answer has a looser tolerance than is claimed, if any is.
std::optional<MethodFault> broken_tolerance(const PluginDescription& claims,
                                            const PluginAnswer& given);

}  // namespace ccdfuzz
