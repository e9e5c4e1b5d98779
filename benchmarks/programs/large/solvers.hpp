#pragma once

namespace fde {

// Prints what solves the equations of a step in a line and in squares, and what else might: nanoseconds of
// the processor an unknown. Of squares as far as this many points of a side.
void measure_solvers(int largest);

// Prints what a sine transform costs by products and by Eigen's fast Fourier transform, nanoseconds a value.
void measure_transforms();

}  // namespace fde
