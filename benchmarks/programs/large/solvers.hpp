// SPDX-License-Identifier: MIT
#pragma once

namespace fde::bench {

// Prints the CPU time, in nanoseconds per unknown, of the solvers for the sparse equations of a step: those
// in use and alternatives, on a line and on squares of up to `largest` x `largest` points.
void measure_solvers(int largest);

// Prints the CPU time, in nanoseconds per value, of a sine transform by matrix products and by Eigen's FFT.
void measure_transforms();

}  // namespace fde::bench
