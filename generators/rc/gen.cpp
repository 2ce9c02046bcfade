#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <stdexcept>

#include "fuzz/mutator/mutate.hpp"
#include "generators/draw/mutate_choices.hpp"
#include "generators/draw_patch.hpp"
#include "generators/prescribe.hpp"
#include "generators/rc/drawn.hpp"
#include "generators/rc/rapidcheck.hpp"
#include "generators/shaped/features.hpp"

namespace ccdfuzz::gen {

namespace {

void demand(const Result<void>& valid, const char* generator) {
  if (!valid) throw std::invalid_argument(generator + (": " + valid.error().message()));
}

void demand(const Domain& promised, const char* generator) {
  const char* const what = promised.plane ? "plane: is of bodies alone"
                           : promised.initial_overlap && !promised.ordinary
                               ? "initial_overlap: needs ordinary"
                               : nullptr;
  if (what != nullptr) throw std::invalid_argument(fmt::format("{}: {}", generator, what));
}

/// What of what is promised a contact breaks, also the order of its pairs; empty if nothing.
std::string broken_by(const Domain& promised, const Contact& contact) {
  const auto& [a, b] = contact.query.patches;
  return promised.order_of(contact.query) == false
             ? promised.broken_by(case_of(contact))
             : fmt::format("takes {}, in this order, and this is {} and {}",
                           fmt::join(promised.pair_texts(), ", "), to_text(a.shape),
                           to_text(b.shape));
}

/// Whether patches of these shapes have contacts of the class.
bool have(const std::array<Shape, 2>& shapes, ContactClass contact) {
  const auto [a, b] = features_of(contact);
  return (has_feature(shapes[0], a) && has_feature(shapes[1], b)) ||
         (has_feature(shapes[0], b) && has_feature(shapes[1], a));
}

/// Shapes of a pair, of the degrees that degree_up_to(most) gives.
template <class Degree>
std::array<Shape, 2> shapes_of(const Domain::Pair& pair, const Degree& degree_up_to) {
  std::array<Shape, 2> shapes;
  for (std::size_t s = 0; s < 2; ++s) {
    const auto most = static_cast<int>(pair[s].max_degree);
    shapes[s].kind = pair[s].shape;
    if (pair[s].shape != ShapeKind::kPoint) shapes[s].n = degree_up_to(most);
    if (pair[s].shape == ShapeKind::kTensor) shapes[s].m = degree_up_to(most);
  }
  return shapes;
}

/// A contact of any class that the shapes have: of each as often as of any other, and a few of what
/// is made most often.
Contact contact_of_any_class(Draw& draw, const ContactRange& range) {
  std::vector<ContactClass> classes(kContactClasses.begin(), kContactClasses.end());
  std::erase_if(classes, [&](ContactClass c) { return range.shapes && !have(*range.shapes, c); });
  const std::uint64_t wanted = draw.below(classes.size() + 1);
  return draw.until([&] { return draw_witnessed(draw, range); },
                    [&](const Contact& contact) {
                      return wanted == 0 || contact_class_of(contact) == classes[wanted - 1];
                    });
}

/// The part of a range whose contacts mostly keep to what is promised; all of it if there is none.
ContactRange kept_to(const Domain& promised, ContactRange range) {
  constexpr int kMostFloatDrift = 2, kLeastDrift = -3;
  if (promised.binary32) {
    range.binary32 = true;
    range.most_drift = std::min(range.most_drift, kMostFloatDrift);
  }
  if (!promised.scale) return range;
  // At a scale of 2^0 speeds are multiples of 2^-3, and points are within 2^6, at t_max, too.
  constexpr int kLeastSpeed = 3, kFarthest = 6;
  const int lowest = std::max(range.lowest, kLeastSpeed - *promised.scale),
            highest = std::min(range.highest, *promised.scale - kFarthest);
  if (lowest <= highest) range.lowest = lowest, range.highest = highest;
  range.most_drift = std::clamp(*promised.scale - kFarthest, kLeastDrift, range.most_drift);
  return range;
}

/// Whether all contacts are of linear patches.
bool are_linear(const ContactRange& range, const Domain& promised) {
  if (range.shapes) return is_linear_pair((*range.shapes)[0], (*range.shapes)[1]);
  return !promised.pairs.empty() &&
         std::ranges::all_of(promised.pairs, [](const Domain::Pair& pair) {
           const auto [a, b] = shapes_of(pair, [](int most) { return most; });
           return is_linear_pair(a, b);
         });
}

/// Draws a class anew after each contact that is not promised: there may be none of it that is.
Contact drawn_contact(Draw& draw, const ContactRange& range, const Domain& promised) {
  int refused = 0;
  return draw.until(
      [&] {
        if (promised.pairs.empty()) return contact_of_any_class(draw, range);
        ContactRange of_pair = range;
        of_pair.shapes = shapes_of(promised.pairs[draw.below(promised.pairs.size())],
                                   [&](int most) { return draw.integer(1, most); });
        return contact_of_any_class(draw, of_pair);
      },
      [&](const Contact& contact) {
        if (promised.broken_by(case_of(contact)).empty()) return true;
        if (++refused < kMostRefused) return false;
        throw std::invalid_argument(
            fmt::format("gen::contact: none of {} contacts of this range keeps to: {}", refused,
                        promised.text()));
      });
}

}  // namespace

rc::Gen<ChoiceNumbers> choices() {
  const Maker<ChoiceNumbers> same = [](const ChoiceNumbers& numbers) {
    return Made<ChoiceNumbers>{std::make_shared<const ChoiceNumbers>(numbers), numbers};
  };
  return rc::Gen<ChoiceNumbers>([same](const rc::Random& random, int) {
    Draw draw{Random(rc::Random(random).next())};
    const Made<ChoiceNumbers> made = *same(drawn_choices(draw));
    return shrinking(made, ChoiceShrinker(made.numbers), same);
  });
}

rc::Gen<Contact> contact(const ContactRange& range, const Domain& promised) {
  demand(validate(range), "gen::contact");
  demand(promised, "gen::contact");
  const int least =
      !promised.ordinary && are_linear(range, promised) ? kLeastLinearScale : kLeastScale;
  if (promised.scale && *promised.scale < least) {
    throw std::invalid_argument(
        fmt::format("gen::contact: scale: {} is not at least {}", *promised.scale, least));
  }
  if (range.shapes && !promised.pairs.empty()) {
    throw std::invalid_argument(
        "gen::contact: shapes: are given, and so are pairs that are promised");
  }
  for (const Domain::Pair& pair : promised.pairs) {
    ContactRange largest = range;
    largest.shapes = shapes_of(pair, [](int most) { return most; });
    demand(validate(largest), "gen::contact");
  }
  return drawn([range = kept_to(promised, range), promised](Draw& draw) {
    return drawn_contact(draw, range, promised);
  });
}

rc::Gen<Case> inverse(const GeneratorOptions& options) {
  demand(validate(options), "gen::inverse");
  return drawn([options](Draw& draw) { return generate(options, draw).value; });
}

rc::Gen<Case> inverse() {
  return drawn([](Draw& draw) {
    GeneratorOptions options = draw_generator_options(draw);
    if (options.family == Family::kRegular && !options.shapes && !draw.coin()) {
      options.construction = Construction::kPaper;
    }
    return generate(options, draw).value;
  });
}

rc::Gen<Contact> mutant(const rc::Gen<Contact>& of, const Domain& promised) {
  demand(promised, "gen::mutant");
  return rc::gen::map(rc::gen::tuple(of, of, choices()), [promised](const auto& parts) {
    const Contact &mother = std::get<0>(parts), &father = std::get<1>(parts);
    if (const std::string why = broken_by(promised, mother); !why.empty()) {
      throw std::invalid_argument("gen::mutant: a contact of `of` is not promised: " + why);
    }
    Draw draw = Draw::from_numbers(std::get<2>(parts));
    try {
      return draw.until([&] { return mutate(mother, father, draw); },
                        [&](const Contact& mutant) { return broken_by(promised, mutant).empty(); });
    } catch (const Discarded&) {
      return mother;
    }
  });
}

rc::Gen<std::string> method(const std::function<bool(const MethodInfo&)>& filter) {
  std::vector<std::string> specs;
  for (const MethodInfo& info : registered_methods()) {
    if (!filter(info)) continue;
    if (!info.spec.ends_with(":F")) {
      specs.push_back(info.spec);
      continue;
    }
    for (const char* factor : {"1e-16", "1e-12", "1e-8", "1e-3"}) {
      specs.push_back(info.spec.substr(0, info.spec.size() - 1) + factor);
    }
  }
  if (specs.empty()) throw std::invalid_argument("gen::method: the filter takes no method");
  return rc::gen::elementOf(specs);
}

rc::Gen<std::string> method() {
  return method([](const MethodInfo&) { return true; });
}

}  // namespace ccdfuzz::gen

rc::Gen<ccdfuzz::Shape> rc::Arbitrary<ccdfuzz::Shape>::arbitrary() {
  constexpr int kMostDegree = 4;
  return ccdfuzz::gen::drawn(
      [](ccdfuzz::Draw& draw) { return ccdfuzz::draw_shape(draw, kMostDegree); });
}

rc::Gen<ccdfuzz::Query> rc::Arbitrary<ccdfuzz::Query>::arbitrary() {
  return ccdfuzz::gen::drawn([](ccdfuzz::Draw& draw) {
    return draw.coin() ? ccdfuzz::draw_any_query(draw)
                       : ccdfuzz::gen::drawn_contact(draw, {}, {}).query;
  });
}
