#include "generators/generate.hpp"

#include <fmt/format.h>

#include "generators/finalize.hpp"
#include "generators/moving_plane.hpp"
#include "generators/one_sided.hpp"

namespace ccdfuzz {

std::string_view name_of(Discard reason) {
  constexpr std::array<std::string_view, kDiscards.size()> names = {"static check", "first contact",
                                                                    "round trip"};
  return names.at(static_cast<size_t>(reason));
}

Result<void> validate(const GeneratorOptions& options) {
  if (options.kind != CaseKind::kRP && options.kind != CaseKind::kRN) {
    return input_error("--kind", fmt::format("{} is not generated", name_of(options.kind)));
  }
  if (options.eps_t_exponent < -40 || options.eps_t_exponent > -1) {
    return input_error(
        "--eps-t", fmt::format("exponent {} is not between -40 and -1", options.eps_t_exponent));
  }
  return {};
}

Generated generate(const GeneratorOptions& options, std::uint64_t index) {
  CCDFUZZ_VERIFY(validate(options));
  // Neither kind nor eps_T is part of the key: a negative case has the patches of the positive one.
  Random random = Random::keyed({options.seed, index, static_cast<std::uint64_t>(options.contact),
                                 static_cast<std::uint64_t>(options.construction),
                                 static_cast<std::uint64_t>(options.family)});
  Generated out;
  const auto discard = [&out](Discard reason) {
    ++out.discards.discarded[static_cast<size_t>(reason)];
  };
  for (;;) {
    ++out.discards.attempts;
    const PlanarScene planar = one_sided_scene(options.contact, random);
    if (!moving_plane_separates(planar.scene, planar.normal)) {
      discard(Discard::kFirstContact);
      continue;
    }
    std::optional<Case> made = finalize(planar.scene, options);
    if (!made) {
      discard(Discard::kRoundTrip);
      continue;
    }
    out.value = std::move(*made);
    break;
  }
  Origin& origin = out.value.origin;
  origin.contact = name_of(options.contact);
  origin.kind = name_of(options.kind);
  origin.generator = "one-sided";
  origin.seed = options.seed;
  origin.index = index;
  origin.ccdfuzz = CCDFUZZ_VERSION;
  return out;
}

}  // namespace ccdfuzz
