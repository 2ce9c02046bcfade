#include "hunt/draw.hpp"

#include "eval/horizons.hpp"
#include "hunt/draw_linear_case.hpp"
#include "hunt/scale.hpp"

namespace ccdfuzz {

namespace {

/// What the draws of a class go round: both constructions with all kinds of cases, and each stress
/// family that has the class, with the kinds it has.
struct Ground {
  Construction construction;
  Family family;
  std::vector<CaseKind> kinds;
};

std::vector<Ground> grounds_of(ContactClass contact) {
  std::vector<Ground> grounds;
  const auto add = [&](Construction construction, Family family) {
    Ground ground{construction, family, {}};
    for (const CaseKind kind : kCaseKinds) {
      if (is_made(family, contact, kind)) ground.kinds.push_back(kind);
    }
    if (!ground.kinds.empty()) grounds.push_back(std::move(ground));
  };
  for (const Construction c : kConstructions) add(c, Family::kRegular);
  for (const Family f : kFamilies) {
    if (f != Family::kRegular) add(Construction::kOneSided, f);
  }
  return grounds;
}

void keep_within(Draw& drawn, std::optional<int> scale) {
  if (!scale) return;
  std::erase_if(drawn.asked, [&](const Case& c) { return !is_within_scale(c.query, *scale); });
}

}  // namespace

Draw draw(ContactClass contact, std::uint64_t seed, std::uint64_t index, std::optional<int> scale) {
  static const auto grounds = [] {
    std::array<std::vector<Ground>, kContactClasses.size()> all;
    for (const ContactClass c : kContactClasses) all[static_cast<size_t>(c)] = grounds_of(c);
    return all;
  }();
  const std::vector<Ground>& around = grounds[static_cast<size_t>(contact)];
  const Ground& ground = around[index % around.size()];
  const std::uint64_t round = index / around.size();
  GeneratorOptions options;
  options.contact = contact;
  options.construction = ground.construction;
  options.family = ground.family;
  options.kind = ground.kinds[round % ground.kinds.size()];
  options.seed = seed;
  Case known = generate(options, round).value;
  Draw drawn;
  if (known.truth.collides == false) {
    drawn.asked.push_back(std::move(known));
  } else {
    for (const double factor : kHorizonFactors) {
      if (auto asked = at_horizon(known, factor)) drawn.asked.push_back(std::move(*asked));
    }
  }
  keep_within(drawn, scale);
  return drawn;
}

Draw draw_of_linear(ContactClass contact, std::uint64_t seed, std::uint64_t index,
                    std::optional<int> scale) {
  Draw drawn{{draw_linear_case(contact, seed, index)}};
  keep_within(drawn, scale);
  return drawn;
}

std::shared_ptr<const Draw> DrawCache::get(ContactClass contact, std::uint64_t index) {
  std::vector<Slot>& slots = slots_[static_cast<size_t>(contact)];
  {
    const std::lock_guard lock(mutex_);
    slots.resize(kKept);
    const Slot& slot = slots[index % kKept];
    if (slot.draw && slot.index == index) return slot.draw;
  }
  // Made outside the lock: two threads may make the same draw, and then it is the same draw.
  const auto make = linear_ ? draw_of_linear : draw;
  auto made = std::make_shared<const Draw>(make(contact, seed_, index, scale_));
  const std::lock_guard lock(mutex_);
  // A straggler's old draw must not evict the one that the others are about to need.
  if (Slot& slot = slots[index % kKept]; !slot.draw || slot.index < index) slot = {index, made};
  return made;
}

}  // namespace ccdfuzz
