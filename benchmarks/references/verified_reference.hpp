// SPDX-License-Identifier: MIT
#pragma once

#include "fdebench/benchmarks/scenes/scene.hpp"

namespace fde::bench {

// Compares a reference at three times with two schemes that share no code with it, radau_exponentials and
// spectral_collocation, with a tolerance of 1e-5 of the solution. Throws std::runtime_error naming the
// column, the time and the three values if the schemes agree with each other to a thousandth of the solution
// and the reference differs by more than a hundredth. There is no check if one of them refuses the problem or
// does not finish within two seconds.
void require_agreement(const Scene& scene, const reference::Reference& reference);

}  // namespace fde::bench
