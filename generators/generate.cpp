#include "generators/generate.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/verify.hpp"
#include "certify/checker/check_case.hpp"
#include "generators/attempts.hpp"
#include "generators/bodies.hpp"
#include "generators/elsewhere.hpp"
#include "generators/finalize.hpp"
#include "generators/first_contact.hpp"
#include "generators/paper.hpp"
#include "generators/planted.hpp"
#include "generators/prescribe.hpp"
#include "generators/shaped/families.hpp"
#include "generators/shaped/shaped_case.hpp"
#include "generators/twins.hpp"

namespace ccdfuzz {

std::string_view name_of(Family family) {
  return row_of(family).name;
}

std::string_view description_of(Family family) {
  return row_of(family).description;
}

namespace {

int eps_t_exponent(const GeneratorOptions& options) {
  const bool grazes = is_grazing(options.kind) || is_grazing(options.family);
  return options.eps_t_exponent.value_or(grazes ? -10 : -20);
}

}  // namespace

Dyadic eps_t(const GeneratorOptions& options) {
  return {1, eps_t_exponent(options)};
}

bool is_made(Family family, ContactClass contact, CaseKind kind) {
  const auto classes = row_of(family).classes[static_cast<size_t>(kind)];
  return std::ranges::find(classes, contact) != classes.end();
}

Result<void> validate(const GeneratorOptions& options) {
  if (const int e = eps_t_exponent(options); e < -40 || e > -1) {
    return input_error("eps_t", "2^{} is not in [2^-40, 2^-1]", e);
  }
  if (options.proof_pops == 0) return input_error("proof_pops", "0 is not at least 1");
  if (has_own_shapes(options.family) && options.shapes) {
    return input_error("shape", "the family {} has shapes of its own", name_of(options.family));
  }
  if (is_of_bodies(options.family) && !has_bodies(options.bodies, options.contact)) {
    return input_error("contact", "bodies of the kinds that are taken have no {}",
                       name_of(options.contact));
  }
  if (!is_made(options.family, options.contact, CaseKind::kRP)) {
    return input_error("contact", "the family {} has no {}", name_of(options.family),
                       name_of(options.contact));
  }
  if (!is_made(options.family, options.contact, options.kind)) {
    const bool is_hit_later = options.kind == CaseKind::kNMN && is_grazing(options.family) &&
                              is_of_a_mesh(options.family);
    return input_error(
        "kind", "{} of {} is not generated in the family {}{}", name_of(options.kind),
        name_of(options.contact), name_of(options.family),
        is_hit_later ? ": past the near miss the body hits the mesh, as in mesh" : "");
  }
  if (options.plane && !is_of_bodies(options.family)) {
    return input_error("plane", "the family {} is not of bodies", name_of(options.family));
  }
  if (is_shaped(options)) return validate_shaped(options);
  if (options.plane && is_of_a_mesh(options.family)) {
    return input_error("plane", "there are no meshes in a plane");
  }
  if (options.plane && is_grazing(options.family) && options.family != Family::kBodiesGrazing) {
    return input_error("plane", "bodies of {} turn out of it", name_of(options.family));
  }
  const auto features = features_of(options.contact);
  if (options.plane && std::ranges::find(features, Feature::kFace) != features.end()) {
    return input_error("contact", "bodies in a plane have no {}", name_of(options.contact));
  }
  return {};
}

namespace {

/// With a budget of proofs by search that is not the command line's.
std::string generator_name(const GeneratorOptions& options) {
  std::string name(options.family == Family::kRegular ? name_of(options.construction)
                                                      : name_of(options.family));
  if (options.family == Family::kRegular && options.proof_pops != GeneratorOptions().proof_pops) {
    name += fmt::format(", proven in {} pops", options.proof_pops);
  }
  return name;
}

/// So many refusals mean that the construction is broken. Even where but one construction in 20 is
/// accepted, their probability is below 2^-140; none is that rare with the default budget. Where
/// one in 50 is, it is below 2^-58.
constexpr std::uint64_t kMaxAttempts = 2000;

/// The stream of random numbers of a case. Neither kind nor eps_T is part of its key, but that
/// grazing ones have their own: a negative case has the patches of the positive one.
Random stream_of(const GeneratorOptions& options, std::uint64_t index) {
  const auto contact = static_cast<std::uint64_t>(options.contact);
  const auto construction = static_cast<std::uint64_t>(options.construction);
  const auto family = static_cast<std::uint64_t>(options.family);
  if (is_grazing(options.kind)) {
    return Random::keyed({options.seed, index, contact, construction, family, 1});
  }
  return Random::keyed({options.seed, index, contact, construction, family});
}

/// One attempt at a case of two quadratic triangles, of the paper's construction or twins, or why
/// it was thrown away.
Attempted quadratic_case(const GeneratorOptions& options, Draw& draw) {
  std::optional<Scene> scene =
      options.family == Family::kTwins
          ? twin_scene(options.contact, draw)
          : paper_scene(options.contact, is_grazing(options.kind), draw);  // Steps I to IV
  if (!scene) return tl::unexpected(Discard::kStaticCheck);
  const bool near_miss = options.kind == CaseKind::kNMN;
  if (near_miss) part(*scene, draw.integer(kLeastGap, kLargestGap));
  const std::optional<Query> query = to_query(scene->patches, 1);
  if (!query) return tl::unexpected(Discard::kRoundTrip);
  Case made;
  made.query = *query;
  if (near_miss) return proven_apart(std::move(made), options);
  const auto& [t, x] = scene->contact;
  say_contact(made, {t.rational(), {uv_of(x[0]), uv_of(x[1])}});
  if (options.family == Family::kRegular &&
      !prove_first_contact(*scene, made, t - eps_t(options), is_grazing(options.kind),
                           options.proof_pops)) {
    return tl::unexpected(Discard::kFirstContact);
  }
  return as_asked(std::move(made), options);
}

/// One attempt at a case of the family kAnywhere.
Attempted case_anywhere(const GeneratorOptions& options, Draw& draw) {
  if (!options.shapes && draw.coin()) {
    const Case base = planted_case(options.contact, draw);
    return elsewhere(base, draw);
  }
  GeneratorOptions base = options;
  base.construction = Construction::kOneSided;
  base.family = draw.until([&] { return draw.pick(kFamilies); },
                           [&](Family family) {
                             base.family = family;
                             return family != Family::kAnywhere && validate(base).has_value();
                           });
  const auto attempt = is_shaped(base) ? shaped_case : quadratic_case;
  return attempt(base, draw).map([&](const Case& made) { return elsewhere(made, draw); });
}

Attempt* attempt_of(const GeneratorOptions& options) {
  if (options.family == Family::kAnywhere) return case_anywhere;
  if (const auto own = std::get_if<Attempt*>(&row_of(options.family).made_by)) return *own;
  return is_shaped(options) ? shaped_case : quadratic_case;
}

}  // namespace

Generated generate(const GeneratorOptions& options, Draw& draw) {
  CCDFUZZ_VERIFY(validate(options));
  const auto attempt = attempt_of(options);
  Generated out;
  const auto made = draw.until(
      [&] {
        if (out.discards.attempts == kMaxAttempts) {
          CCDFUZZ_VERIFY(options.eps_t_exponent);
          throw NothingAccepted(fmt::format("with 2^{} none of {} constructions is accepted",
                                            *options.eps_t_exponent, kMaxAttempts));
        }
        ++out.discards.attempts;
        Attempted tried = attempt(options, draw);
        if (!tried) ++out.discards.discarded[static_cast<size_t>(tried.error())];
        return tried;
      },
      [](const auto& tried) { return tried.has_value(); });
  // Scenes of patches are checked where they become cases.
  CCDFUZZ_VERIFY(!std::holds_alternative<Attempt*>(row_of(options.family).made_by) ||
                 check_case(*made));
  out.value = *made;
  Origin& origin = out.value.origin;
  origin.contact = name_of(options.contact);
  origin.kind = name_of(options.kind);
  origin.generator = generator_name(options);
  origin.ccdfuzz = CCDFUZZ_VERSION;
  return out;
}

Generated generate(const GeneratorOptions& options, std::uint64_t index) {
  Draw draw(stream_of(options, index));
  Generated out = generate(options, draw);
  out.value.origin.seed = options.seed;
  out.value.origin.index = index;
  return out;
}

}  // namespace ccdfuzz
