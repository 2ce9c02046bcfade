#include "properties/traced.hpp"

#include <fmt/format.h>

#include "case/case_json.hpp"
#include "ccd/witness_trace/trace.hpp"
#include "generators/draw_contact.hpp"
#include "method/method.hpp"

namespace ccdfuzz {

namespace {

Check no_contact_is_lost(const char* method, const ContactRange& range, Draw& choices) {
  const Result<Case> drawn = draw_contact(choices, range);
  if (!drawn) return Check::discarded(drawn.error().message());
  const auto tracer = *make_tracer(method);
  const Trace& trace = tracer->trace(drawn->query, *drawn->truth.witness, {.precision = 0x1p-8});
  if (!trace.lost) return Check::holds();
  return Check::fails(fmt::format("{} loses the contact at level {}, axis {}\n{}", method,
                                  trace.loss->place.level, trace.loss->by.axis, to_json(*drawn)));
}

constexpr ContactRange kOrdinaryTrace;
constexpr ContactRange kTinyTrace{-545, -530};
constexpr ContactRange kWideTrace{
    .lowest = -1000, .highest = 900, .max_degree = 5, .elsewhere = true};

}  // namespace

std::vector<Property> traced_properties() {
  constexpr auto kHolds = Expectation::kHolds, kFails = Expectation::kFails;
  constexpr const char* kClaim = "No pair of boxes that holds a contact is dropped on the way";
  return {
      {"tdibm.trace", kClaim, "Section 3, in double arithmetic", kFails,
       [](Draw& c) { return no_contact_is_lost("tdibm", kOrdinaryTrace, c); }},
      {"tdibm-e.trace", kClaim, "Section 4.6", kHolds,
       [](Draw& c) { return no_contact_is_lost("tdibm-e", kOrdinaryTrace, c); }},
      {"tdibm-e.trace_underflow", kClaim, "Section 4.6, for coordinates about 2^-535", kFails,
       [](Draw& c) { return no_contact_is_lost("tdibm-e", kTinyTrace, c); }},
      {"tdibm-e-literal.trace", kClaim, "Section 4.6, with eps_Phi's sign as printed", kFails,
       [](Draw& c) { return no_contact_is_lost("tdibm-e-literal", kOrdinaryTrace, c); }},
      {"tdibm-rational.trace", kClaim, "exact arithmetic", kHolds,
       [](Draw& c) { return no_contact_is_lost("tdibm-rational", kWideTrace, c); }},
      {"tdibm-c.trace", kClaim, "src/ccd/certified/DERIVATION.md", kHolds,
       [](Draw& c) { return no_contact_is_lost("tdibm-c", kWideTrace, c); }},
  };
}

}  // namespace ccdfuzz
