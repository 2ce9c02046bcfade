// CCD codes held to contacts that are there, by RapidCheck. The first one has a fault.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <ccdfuzz/rapidcheck.hpp>

#include <Eigen/Geometry>

/// "hit" at once, unless the boxes of the control points are apart. The fault: it looks at the end
/// of the step alone, when the patches may have passed through each other.
static ccdfuzz::Answer my_ccd(const ccdfuzz::Query& query) {
  std::array<Eigen::AlignedBox3d, 2> boxes;
  for (std::size_t s = 0; s < 2; ++s) {
    for (const Eigen::Vector3d& p : query.patches[s].at(query.t_max)) boxes[s].extend(p);
  }
  return boxes[0].intersects(boxes[1]) ? ccdfuzz::Answer::hit(0) : ccdfuzz::Answer::miss();
}

RC_GTEST_PROP(Mine, MissesNothing, (const ccdfuzz::Contact& c)) {
  RC_ASSERT(!ccdfuzz::is_false_negative(c, my_ccd(c.query)));
}

/// What code of triangle meshes is held to.
RC_GTEST_PROP(Mine, MissesNothingOfMeshes, ()) {
  ccdfuzz::Domain promised;
  promised.pairs = ccdfuzz::linear_pairs();
  promised.ordinary = true;
  const ccdfuzz::Contact c = *ccdfuzz::gen::contact({.off_grid = true}, promised);
  RC_ASSERT(!ccdfuzz::is_false_negative(c, my_ccd(c.query), {.time_tolerance = 1e-9}));
}

RC_GTEST_PROP(TdibmC, MissesNothing, (const ccdfuzz::Contact& c)) {
  RC_TAG(std::string(ccdfuzz::name_of(ccdfuzz::contact_class_of(c))));
  const auto method = *ccdfuzz::make_method("tdibm-c");
  RC_ASSERT(!ccdfuzz::is_false_negative(c, method->answer(c.query, {})));
}
