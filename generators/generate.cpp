#include "generators/generate.hpp"

#include <fmt/format.h>

#include "generators/finalize.hpp"
#include "generators/first_contact.hpp"
#include "generators/grazing.hpp"
#include "generators/one_sided.hpp"
#include "generators/paper.hpp"
#include "generators/stress.hpp"
#include "numeric/verify.hpp"

namespace ccdfuzz {

std::string_view name_of(Discard reason) {
  constexpr std::array<std::string_view, kDiscards.size()> names = {"static check", "first contact",
                                                                    "round trip"};
  return names.at(static_cast<size_t>(reason));
}

std::string_view name_of(Family family) {
  constexpr std::array<std::string_view, kFamilies.size()> names = {
      "regular", "flat-grazing", "common-velocity", "scaled", "twins", "interior-time"};
  return names.at(static_cast<size_t>(family));
}

namespace {

bool is_grazing(CaseKind kind) {
  return kind == CaseKind::kNHP || kind == CaseKind::kNMN;
}

int eps_t_exponent(const GeneratorOptions& options) {
  return options.eps_t_exponent.value_or(is_grazing(options.kind) ? -10 : -20);
}

}  // namespace

Result<void> validate(const GeneratorOptions& options) {
  if (options.family != Family::kRegular && options.kind != CaseKind::kRP) {
    return input_error("--kind", fmt::format("{} is not generated in the family {}",
                                             name_of(options.kind), name_of(options.family)));
  }
  if (const int e = eps_t_exponent(options); e < -40 || e > -1) {
    return input_error("--eps-t", fmt::format("exponent {} is not between -40 and -1", e));
  }
  return {};
}

std::string_view name_of(Construction construction) {
  return construction == Construction::kPaper ? "paper" : "one-sided";
}

namespace {

std::string_view generator_name(const GeneratorOptions& options) {
  return options.family == Family::kRegular ? name_of(options.construction)
                                            : name_of(options.family);
}

/// Even where but one construction in 20 is accepted (none is that rare), so many refusals have a
/// probability below 2^-140: the construction is broken.
constexpr std::uint64_t kMaxAttempts = 2000;

/// Near-misses stay 2^-20 to 2^-8 apart.
constexpr int kLeastGap = -20, kLargestGap = -8;

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

/// Steps I to IV; nullopt if the static check refused the result.
std::optional<Scene> construct(const GeneratorOptions& options, Random& random) {
  if (options.family != Family::kRegular) {
    return stress_scene(options.family, options.contact, random);
  }
  const bool grazing = is_grazing(options.kind);
  if (options.construction == Construction::kPaper) {
    return paper_scene(options.contact, grazing, random);
  }
  OneSidedStyle style;
  style.grazing = grazing;
  style.flat_edges = !grazing;
  return one_sided_scene(options.contact, style, random);
}

}  // namespace

Generated generate(const GeneratorOptions& options, std::uint64_t index) {
  CCDFUZZ_VERIFY(validate(options));
  Random random = stream_of(options, index);
  const Dyadic eps_t(1, eps_t_exponent(options));
  Generated out;
  const auto discard = [&out](Discard reason) {
    ++out.discards.discarded[static_cast<size_t>(reason)];
  };
  for (;;) {
    CCDFUZZ_VERIFY(out.discards.attempts < kMaxAttempts);
    ++out.discards.attempts;
    std::optional<Scene> scene = construct(options, random);
    if (!scene) {
      discard(Discard::kStaticCheck);
      continue;
    }
    if (options.kind == CaseKind::kNMN) {
      part(*scene, static_cast<int>(random.between(kLeastGap, kLargestGap)));
    }
    const std::optional<Query> query = to_query(*scene);
    if (!query) {
      discard(Discard::kRoundTrip);
      continue;
    }
    std::optional<Absence> clear;
    if (options.family == Family::kRegular) {
      const bool near_miss = options.kind == CaseKind::kNMN;
      if (!near_miss) {
        clear =
            prove_first_contact(*scene, *query, scene->contact.t - eps_t, is_grazing(options.kind));
      } else if (miss_is_proven(*query)) {
        clear = Absence{scene->t_max, {}};
      }
      if (!clear) {
        discard(Discard::kFirstContact);
        continue;
      }
    }
    out.value = finalize(*scene, *query, options.kind, clear);
    break;
  }
  Origin& origin = out.value.origin;
  origin.contact = name_of(options.contact);
  origin.kind = name_of(options.kind);
  origin.generator = generator_name(options);
  origin.seed = options.seed;
  origin.index = index;
  origin.ccdfuzz = CCDFUZZ_VERSION;
  return out;
}

}  // namespace ccdfuzz
