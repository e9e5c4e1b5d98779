#pragma once

#include "scenes/scene.hpp"

namespace fde {

// Compares what is known about the columns of a scene at three times with two schemes that share no code with
// it, radau_exponentials and spectral_collocation, to a tolerance of 1e-5 of the solution. Throws
// std::runtime_error naming the column, the time and the three values where both schemes agree with each
// other to a thousandth of the solution, and the reference is off by more than a hundredth. Where one of them
// refuses the problem, or does not come to its end within two seconds, nothing is said.
void require_agreement(const Scene& scene, const Reference& reference);

}  // namespace fde
