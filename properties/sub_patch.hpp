#pragma once

#include "bezier/cell.hpp"
#include "bezier/patch.hpp"
#include "numeric/exact_scalars.hpp"
#include "properties/property.hpp"

namespace ccdfuzz {

/// The sub-patch over a cell is the patch itself there (Appendix A (b)). Its point at the local
/// parameters `uv` is the patch's point at the parameters that these mean. Exact.
void claim_sub_patch_is_the_restriction(const Shape& shape, const Points<Dyadic>& points,
                                        const Cell& cell, const Uv<Dyadic>& uv);

}  // namespace ccdfuzz
