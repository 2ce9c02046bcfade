#pragma once

#include "case/query.hpp"
#include "generators/draw/draw.hpp"

namespace ccdfuzz {

/// The exponent e of the largest coordinate, which is at least 2^(e-1) and less than 2^e; 0 if all
/// are 0.
int size_exponent(const Points<double>& points);

/// A vector of few bits, from as large as the points down to their last bit; often along one axis.
Vec3<Dyadic> small_vector(const Points<double>& points, Draw& draw);

}  // namespace ccdfuzz
