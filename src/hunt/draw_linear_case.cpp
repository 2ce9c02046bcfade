#include "hunt/draw_linear_case.hpp"

#include "certify/oracle/oracle.hpp"
#include "properties/draw_linear.hpp"

namespace ccdfuzz {

Case draw_linear_case(ContactClass contact, std::uint64_t seed, std::uint64_t index) {
  for (std::uint64_t attempt = 0;; ++attempt) {
    Draw choices = Draw::mostly_small(Random::keyed(
        {seed, index, static_cast<std::uint64_t>(contact), attempt, 0x6c696e656172}));  // "linear"
    const Result<Query> query = draw_linear(choices);
    if (!query || linear_class_of(*query) != contact) continue;
    Case drawn;
    drawn.query = *query;
    drawn.truth = decide(*query).truth;
    if (!drawn.truth.collides) continue;
    drawn.origin.contact = name_of(contact);
    drawn.origin.kind = name_of(*drawn.truth.collides ? CaseKind::kRP : CaseKind::kRN);
    drawn.origin.generator = "linear";
    drawn.origin.seed = seed;
    drawn.origin.index = index;
    return drawn;
  }
}

}  // namespace ccdfuzz
