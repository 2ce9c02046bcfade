#pragma once

#include <optional>

#include "generators/generate.hpp"
#include "generators/rc/drawn.hpp"
#include "properties/draw_contact.hpp"

namespace ccdfuzz::rc_gen {

/// Two patches of any shapes in a contact whose witness is exact; draw_contact. Every shrink is
/// such a case too: of lower degree, with fewer coordinates that are not 0, of fewer bits.
inline rc::Gen<Case> contact_case(const ContactRange& range = {}) {
  const auto tried = drawn([range](ChoiceSource& c) -> std::optional<Case> {
    const Result<Case> made = draw_contact(c, range);
    return made ? std::optional(*made) : std::nullopt;
  });
  const auto made = rc::gen::suchThat(tried, [](const auto& c) { return c.has_value(); });
  return rc::gen::map(made, [](const std::optional<Case>& c) { return *c; });
}

/// A case of the inverse construction, of any class, kind and stress family.
inline rc::Gen<Case> generated_case() {
  return drawn([](ChoiceSource& c) {
    GeneratorOptions options;
    options.construction = Construction::kOneSided;
    options.contact = c.pick(kContactClasses);
    options.family = c.pick(kFamilies);
    if (!is_made(options.family, options.contact, CaseKind::kRP)) options.family = Family::kRegular;
    if (options.family == Family::kRegular) options.kind = c.pick(kCaseKinds);
    options.seed = c.choose(~std::uint64_t{0});
    return generate(options, 0).value;
  });
}

}  // namespace ccdfuzz::rc_gen
