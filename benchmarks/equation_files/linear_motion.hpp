#pragma once

#include <optional>

#include "equation_files/equation_system.hpp"
#include "reference.hpp"

namespace fde {

// The exact solution in the columns of equations that are linear in the unknowns with constant coefficients
// and loads c t^p, or c that is switched at a time: an inverse Laplace transform. Nothing where they are not,
// or have more than 12 rows. Its digits are those of the decimals that name its numbers; there are none where
// a number of the equations, such as 1/3, is no decimal of a double.
std::optional<Reference> linear_motion(const EquationSystem& system, const Problem& problem,
                                       Expressions& all);

}  // namespace fde
