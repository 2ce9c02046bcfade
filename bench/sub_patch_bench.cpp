// Sub-patches from scratch, as Appendix A (b) has them: exact over double.
#include "bench/ratio.hpp"
#include "bezier/cell.hpp"
#include "bezier/exact_patch.hpp"
#include "bezier/restrict.hpp"
#include "generators/draw/draw.hpp"

namespace ccdfuzz {
namespace {

void sub_patch(benchmark::State& state, const Shape& shape) {
  Draw random{Random(1)};
  MovingPatch<double> patch{shape, {}, {}};
  for (int i = 0; i < shape.control_count(); ++i) {
    const Vec3<Dyadic> p = random.vector(20, -16);
    patch.positions.push_back(
        {*p[0].to_double_exactly(), *p[1].to_double_exactly(), *p[2].to_double_exactly()});
  }
  patch.velocities = patch.positions;
  const MovingPatch<Dyadic> exact = exact_patch<Dyadic>(patch);
  Cell cell;
  for (int depth = 0; depth < 6; ++depth) cell = cell.child(shape, depth % shape.child_count());
  const auto corners = cell.corners(shape);
  const auto dyadic_corners = exact_corners<Dyadic>(corners);
  Ratio ratio;
  for ([[maybe_unused]] const auto _ : state) {
    ratio.first([&] { benchmark::DoNotOptimize(restrict_to(exact, dyadic_corners)); });
    ratio.second([&] { benchmark::DoNotOptimize(restrict_to(patch, corners)); });
  }
  ratio.report(state, "exact", "double");
}

BENCHMARK_CAPTURE(sub_patch, triangle_2, Shape::triangle(2));
BENCHMARK_CAPTURE(sub_patch, tensor_3_3, Shape::tensor(3, 3));

}  // namespace
}  // namespace ccdfuzz
