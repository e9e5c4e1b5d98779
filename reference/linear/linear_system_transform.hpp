// SPDX-License-Identifier: MIT
#pragma once

#include "fdebench/reference/linear/linear_system.hpp"
#include "fdebench/reference/linear/transfer_functions/linear_transform.hpp"

namespace fde::reference {

// The Laplace transforms of the outputs, by Cramer's rule with exact determinants. Precondition: the system
// has the form of linear_system.hpp, with one list of loads per row and explicit outputs.
LinearTransform transform_of(const ExactLinearSystem& system);

// Whether the determinant of the transformed system is nonzero: whether the solution is unique.
bool is_regular(const ExactLinearSystem& system);

}  // namespace fde::reference
