#include <gtest/gtest.h>

#ifdef CCDFUZZ_TDIBCCD
#include <solverTD.h>
#include <solverTrad.h>

#include "recBezier.h"
#include "triBezier.h"
#endif

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
template <class Patch>
Patch patch_of(const Shape& shape, const Points<double>& points) {
  Patch out;
  std::size_t place = 0;
  for (int outer = 0; outer <= shape.n; ++outer) {
    const bool triangle = shape.kind == ShapeKind::kTriangle;
    for (int inner = 0; inner <= (triangle ? shape.n - outer : shape.m); ++inner) {
      const int from = triangle ? shape.index(inner, outer) : shape.index(outer, inner);
      out.ctrlp[place++] = points[static_cast<std::size_t>(from)];
    }
  }
  return out;
}

/// Its time of contact, or −1.
template <class Patch, class Bound, template <class, class, class, class> class Solver>
double their_answer(const Query& query, double precision) {
  const auto of = [](const Shape& shape, const Points<double>& points) {
    return patch_of<Patch>(shape, points);
  };
  const auto& [a, b] = query.patches;
  Array2d uv1, uv2;
  return Solver<Patch, Patch, Bound, Bound>::solveCCD(
      of(a.shape, a.positions), of(a.shape, a.velocities), of(b.shape, b.positions),
      of(b.shape, b.velocities), uv1, uv2, BoundingBoxType::OBB, precision, query.t_max);
}

/// Verdicts and times are the same to the last bit, of the first `count` cases of a class and kind.
template <class Patch, class Bound, template <class, class, class, class> class Solver>
void expect_same_answers(const char* spec, const GeneratorOptions& options, std::uint64_t count,
                         double precision) {
  const auto method = *make_method(spec);
  SearchOptions search;
  search.precision = precision;
  for (std::uint64_t index = 0; index < count; ++index) {
    const Query query = generate(options, index).value.query;
    const double theirs = their_answer<Patch, Bound, Solver>(query, precision);
    const Answer ours = method->answer(query, search);
    ASSERT_NE(ours.verdict, Verdict::kUndecided);
    EXPECT_EQ(ours.toi.value_or(-1), theirs)
        << spec << ' ' << name_of(options.contact) << ' ' << name_of(options.kind) << " #" << index;
  }
}

GeneratorOptions of(ContactClass contact, CaseKind kind) {
  GeneratorOptions options;
  options.contact = contact;
  options.kind = kind;
  options.seed = 1;
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
                                                              1e-4);
  options.shapes = {Shape::triangle(3), Shape::triangle(3)};
  expect_same_answers<TriCubicBezier, TriParamBound, SolverTD>("tdibm-h:1e-12@slip", options, 20,
                                                               1e-4);
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
