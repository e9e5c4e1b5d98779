#pragma once

#include <Eigen/Core>

namespace fde {

// c += a b for a of 32 x inner, b of inner x columns, c of 32 x columns, by columns. Written as plainly as
// possible and compiled for the wider vectors of the machine: the yardstick of the history.
void bare_multiply_add(Eigen::Index inner, Eigen::Index columns, const double* a, const double* b, double* c);

}  // namespace fde
