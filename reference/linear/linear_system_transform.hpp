#pragma once

#include "linear/linear_system.hpp"
#include "transfer_functions/linear_transform.hpp"

namespace fde {

// The Laplace transforms of the outputs of a system that is posed as linear_system.hpp says, by Cramer's rule
// with exact determinants.
LinearTransform transform_of(const LinearSystem& system);

// Whether the determinant of the transformed system is other than zero: whether it has one solution.
bool is_regular(const LinearSystem& system);

}  // namespace fde
