#include "base/verify.hpp"
#include "fuzz/mutator/mutate.hpp"
#include "generators/draw/mutate_choices.hpp"
#include "generators/draw_patch.hpp"
#include "generators/rc/drawn.hpp"
#include "generators/rc/rapidcheck.hpp"

namespace ccdfuzz::gen {

namespace {

/// A contact of any class: of each as often as of any other, and a few of what is made most often.
Contact drawn_contact(Draw& draw, const ContactRange& range) {
  const std::uint64_t wanted = draw.below(kContactClasses.size() + 1);
  const auto made = draw.until(
      [&] {
        const Result<Case> drawn = draw_contact(draw, range);
        return drawn ? contact_of(*drawn) : std::nullopt;
      },
      [&](const std::optional<Contact>& contact) {
        if (!contact || wanted == 0) return contact.has_value();
        return contact_class_of(*contact) == kContactClasses.at(wanted - 1);
      });
  return *made;
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

rc::Gen<Contact> contact(const ContactRange& range) {
  return drawn([range](Draw& draw) { return drawn_contact(draw, range); });
}

rc::Gen<Case> inverse(const GeneratorOptions& options) {
  CCDFUZZ_VERIFY(validate(options));
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

rc::Gen<Contact> mutant(const rc::Gen<Contact>& of) {
  return rc::gen::map(rc::gen::tuple(of, of, choices()), [](const auto& parts) {
    const auto& [mother, father, numbers] = parts;
    Draw draw = Draw::from_numbers(numbers);
    return mutate(mother, father, draw);
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
  CCDFUZZ_VERIFY(!specs.empty());
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
                       : ccdfuzz::gen::drawn_contact(draw, {}).query;
  });
}
