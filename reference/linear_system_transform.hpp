#pragma once

#include "linear_system.hpp"
#include "linear_transform.hpp"

namespace fde {

// The Laplace transforms of some components of a system that is posed as linear_system.hpp says, by Cramer's
// rule with exact determinants.
LinearTransform transform_of(const LinearSystem& system, const std::vector<std::size_t>& outputs);

}  // namespace fde
