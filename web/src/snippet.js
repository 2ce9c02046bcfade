// A case as a test of its own for somebody's CCD: numbers as hex floats, nothing to include but
// GoogleTest.
import { hexFloat } from './exact.js';
import { real, shapeOf } from './local.js';

export function googleTest(row, known) {
  const points = (rows) => rows.map((p) => `    {${p.map((x) => hexFloat(real(x))).join(', ')}},`).join('\n');
  const name = (row.id.match(/([A-Za-z0-9-]+)\.jsonl?(?:\.zst)?(?::(\d+))?/) ?? []).slice(1).filter(Boolean).join('_') || 'case';
  const word = name.replace(/[^A-Za-z0-9]+/g, '_').replace(/^(\d)/, 'n$1');
  const arrays = known.patches.map((patch, s) => {
    const { kind, n, m } = shapeOf(patch);
    const degree = kind === 'tensor' ? ` of degrees ${n} and ${m}` : kind === 'point' ? '' : ` of degree ${n}`;
    return `  // Patch ${s + 1}: ${kind}${degree}.
  const std::vector<std::array<double, 3>> positions${s + 1} = {
${points(patch.positions)}
  };
  const std::vector<std::array<double, 3>> velocities${s + 1} = {
${points(patch.velocities)}
  };`;
  });
  const witness = known.truth?.witness;
  const claim = known.truth?.collides
    ? `  // An exact witness: both patches are at the same point at t = ${witness?.t}, (u, v) = (${witness?.uv.map((p) => p.join(', ')).join(') and (')}).
  EXPECT_TRUE(hit);`
    : '  // Proven: nothing touches in [0, t_max].\n  EXPECT_FALSE(hit);';
  return `#include <gtest/gtest.h>

#include <array>
#include <vector>

TEST(Counterexample, ${word}) {
${arrays.join('\n')}
  const double t_max = ${hexFloat(real(known.t_max))};
  const bool hit = my_ccd(positions1, velocities1, positions2, velocities2, t_max);
${claim}
}
`;
}
