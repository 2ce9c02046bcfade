#pragma once

#include "case/taxonomy.hpp"
#include "fuzz/mutator/repair.hpp"
#include "generators/contact.hpp"
#include "generators/generate.hpp"
#include "generators/planted.hpp"

namespace ccdfuzz {

/// Contacts of every class: of random surfaces, of constructed ones, and of curves and points.
inline std::vector<Contact> mutation_bases() {
  std::vector<Contact> bases;
  Draw random{Random::keyed({5})};
  for (const ContactClass contact : kContactClasses) {
    for (int i = 0; i < 4; ++i) {
      bases.push_back(contact_of(planted_case(contact, random)).value());
    }
    GeneratorOptions options{.contact = contact, .construction = Construction::kOneSided};
    bases.push_back(contact_of(generate(options, 0).value).value());
  }
  const auto moving = [&](const Shape& shape) {
    MovingPatch<double> patch{shape, {}, {}};
    for (int i = 0; i < shape.control_count(); ++i) {
      patch.positions.push_back({0.5 * i, 0.25 * i * i, 1.0});
      patch.velocities.push_back({0, 0.125 * i, -1.0});
    }
    return patch;
  };
  for (const int n : {1, 3, 7}) {
    // The point follows the curve's middle.
    Contact q{{{moving(Shape::point()), moving(Shape::curve(n))}, 1.0}, Dyadic(1), {}};
    q.uv[1][0] = Dyadic(Integer(1), -1);
    const Vec3<Dyadic> way = q.point(1) - q.point(0);
    if (add_exactly(q.query.patches[0].positions[0], way)) bases.push_back(q);
  }
  return bases;
}

}  // namespace ccdfuzz
