#include <gtest/gtest.h>

#ifdef CCDFUZZ_TDIBCCD
#include <solverTD.h>
#include <solverTrad.h>

#include "recBezier.h"
#include "recRatBezier.h"
#include "triBezier.h"
#include "triRatBezier.h"
#endif

#include <iostream>

#include "generators/generate.hpp"
#include "method/method.hpp"

namespace ccdfuzz {
namespace {

#ifndef CCDFUZZ_TDIBCCD

TEST(ReleasedProgram, AnswersAsOurReadingOfIt) {
  GTEST_SKIP() << "cmake -DCCDFUZZ_TDIBCCD=DIR names the source tree of TDIB-CCD";
}

#else

/// The program's order of a triangle's control points is by v, then u; of a rectangle's as ours.
/// Its rational classes have four coordinates, the last of which is the weight.
template <class Patch>
Patch patch_of(const MovingPatch<double>& patch, const Points<double>& points) {
  Patch out;
  const Shape& shape = patch.shape;
  std::size_t place = 0;
  for (int outer = 0; outer <= shape.n; ++outer) {
    const bool triangle = shape.kind == ShapeKind::kTriangle;
    for (int inner = 0; inner <= (triangle ? shape.n - outer : shape.m); ++inner) {
      const int from = triangle ? shape.index(inner, outer) : shape.index(outer, inner);
      auto& point = out.ctrlp[place++];
      const auto index = static_cast<std::size_t>(from);
      const double weight = patch.weights.empty() ? 1 : patch.weights[index];
      for (int k = 0; k < 3; ++k) point[k] = weight * points[index][k];
      if constexpr (std::decay_t<decltype(point)>::RowsAtCompileTime == 4) point[3] = weight;
    }
  }
  return out;
}

/// Its time of contact, or −1.
template <class Patch, class Bound, template <class, class, class, class> class Solver>
double their_answer(const Query& query, double precision) {
  const auto of = [](const MovingPatch<double>& patch, const Points<double>& points) {
    return patch_of<Patch>(patch, points);
  };
  const auto& [a, b] = query.patches;
  Array2d uv1, uv2;
  return Solver<Patch, Patch, Bound, Bound>::solveCCD(
      of(a, a.positions), of(a, a.velocities), of(b, b.positions), of(b, b.velocities), uv1, uv2,
      BoundingBoxType::OBB, precision, query.t_max);
}

/// Verdicts and times are the same, of the first `count` cases of a class and kind. The times are
/// so to the last bit but for a rounding of the sums of axes.
template <class Patch, class Bound, template <class, class, class, class> class Solver>
void expect_same_answers(const char* spec, const GeneratorOptions& options, std::uint64_t count,
                         double precision, double rounding = 0) {
  const auto method = *make_method(spec);
  SearchOptions search;
  search.precision = precision;
  for (std::uint64_t index = 0; index < count; ++index) {
    const Query query = generate(options, index).value.query;
    const double theirs = their_answer<Patch, Bound, Solver>(query, precision);
    const Answer ours = method->answer(query, search);
    ASSERT_NE(ours.verdict, Verdict::kUndecided);
    EXPECT_NEAR(ours.toi.value_or(-1), theirs, rounding)
        << spec << ' ' << name_of(options.contact) << ' ' << name_of(options.kind) << " #" << index;
  }
}

GeneratorOptions of(ContactClass contact, CaseKind kind) {
  GeneratorOptions options{.contact = contact, .kind = kind, .seed = 1};
  return options;
}

TEST(ReleasedProgram, AnswersAsOurReadingOfIt) {
  for (const ContactClass contact :
       {ContactClass::kEE, ContactClass::kVF, ContactClass::kVE, ContactClass::kVV}) {
    for (const CaseKind kind : {CaseKind::kRP, CaseKind::kRN}) {
      expect_same_answers<TriQuadBezier, TriParamBound, SolverTD>("tdibm-h:1e-12@slip",
                                                                  of(contact, kind), 50, 1e-4);
    }
  }
}

TEST(ReleasedProgram, AnswersAsOurReadingOfItOfOtherShapes) {
  GeneratorOptions options = of(ContactClass::kVF, CaseKind::kRP);
  options.construction = Construction::kOneSided;
  options.shapes = {Shape::tensor(2, 2), Shape::tensor(2, 2)};
  expect_same_answers<RecQuadBezier, RecParamBound, SolverTD>("tdibm-h:1e-12@slip", options, 20,
                                                              1e-4, 0x1p-40);
  options.shapes = {Shape::triangle(3), Shape::triangle(3)};
  expect_same_answers<TriCubicBezier, TriParamBound, SolverTD>("tdibm-h:1e-12@slip", options, 20,
                                                               1e-4, 0x1p-40);
}

/// Planted contacts of rational patches, inside of [0, t_max]. tdibm-c misses none, and is late for
/// none. What the program misses or finds late is counted. Its times are those of our reading of
/// it, but for rounding.
template <class Patch, class Bound>
void compare_on_rational(const Shape& shape, std::uint64_t count) {
  const double precision = 1e-4;
  const auto certified = *make_method("tdibm-c"), reading = *make_method("tdibm-h:1e-12@slip");
  SearchOptions search;
  search.precision = precision;
  int asked = 0, missed = 0, late = 0, differ = 0, undecided = 0;
  for (const ContactClass contact : kContactClasses) {
    GeneratorOptions options = of(contact, CaseKind::kRP);
    options.family = Family::kWeighted;
    options.shapes = {shape, shape};
    if (!validate(options)) continue;
    for (std::uint64_t index = 0; index < count; ++index) {
      const Case made = generate(options, index).value;
      Query query = made.query;
      query.t_max *= 1.5;
      const double t = made.truth.witness->t.get_d();
      const Answer ours = certified->answer(query, search);
      EXPECT_NE(ours.verdict, Verdict::kMiss)
          << shape.n << ' ' << name_of(contact) << " #" << index;
      undecided += ours.verdict == Verdict::kUndecided ? 1 : 0;
      EXPECT_LE(ours.toi.value_or(0), t);
      const double theirs = their_answer<Patch, Bound, SolverTD>(query, precision);
      const Answer read = reading->answer(query, search);
      ++asked;
      missed += theirs == -1 ? 1 : 0;
      late += theirs > t ? 1 : 0;
      differ += std::abs(read.toi.value_or(-1) - theirs) > precision ? 1 : 0;
    }
  }
  std::cout << to_text(shape) << ": of " << asked << " contacts " << missed << " missed and "
            << late << " late; " << differ
            << " answers are not those of tdibm-h; tdibm-c gave up on " << undecided << '\n';
  EXPECT_EQ(differ, 0);
}

TEST(ReleasedProgram, IsAskedAboutPlantedContactsOfRationalPatches) {
  compare_on_rational<TriQuadRatBezier, TriParamBound>(Shape::triangle(2), 4);
  compare_on_rational<TriCubicRatBezier, TriParamBound>(Shape::triangle(3), 4);
  compare_on_rational<RecQuadRatBezier, RecParamBound>(Shape::tensor(2, 2), 4);
  compare_on_rational<RecCubicRatBezier, RecParamBound>(Shape::tensor(3, 3), 4);
}

TEST(ReleasedProgram, AnswersAsOurTraditionalMethod) {
  for (const CaseKind kind : {CaseKind::kRP, CaseKind::kRN}) {
    expect_same_answers<TriQuadBezier, TriParamBound, SolverTrad>(
        "trad", of(ContactClass::kVV, kind), 20, 1e-2);
  }
}

#endif

}  // namespace
}  // namespace ccdfuzz
