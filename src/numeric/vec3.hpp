#pragma once

#include <Eigen/Core>
#include <type_traits>

namespace ccdfuzz {

/// A scalar that vectors may have: an exact one needs Eigen's traits (numeric/exact_scalars.hpp).
template <class S>
concept VectorScalar = std::is_arithmetic_v<S> || requires {
  Eigen::NumTraits<S>::kIsExact;
};

template <VectorScalar S>
using Vec3 = Eigen::Matrix<S, 3, 1>;

}  // namespace ccdfuzz
