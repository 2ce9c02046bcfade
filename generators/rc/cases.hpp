#pragma once

#include <optional>

#include "generators/draw_contact.hpp"
#include "generators/generate.hpp"
#include "generators/rc/drawn.hpp"

namespace ccdfuzz::rc_gen {

/// Two patches of any shapes in a contact whose witness is exact; draw_contact. Every shrink is
/// such a case too: of lower degree, with fewer coordinates that are not 0, of fewer bits.
inline rc::Gen<Case> contact_case(const ContactRange& range = {}) {
  const auto tried = drawn([range](Draw& c) -> std::optional<Case> {
    const Result<Case> made = draw_contact(c, range);
    return made ? std::optional(*made) : std::nullopt;
  });
  const auto made = rc::gen::suchThat(tried, [](const auto& c) { return c.has_value(); });
  return rc::gen::map(made, [](const std::optional<Case>& c) { return *c; });
}

/// A case of the inverse construction, of any class, kind and stress family.
inline rc::Gen<Case> generated_case() {
  return drawn([](Draw& c) { return generate(draw_generator_options(c), 0).value; });
}

}  // namespace ccdfuzz::rc_gen
