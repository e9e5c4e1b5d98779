// SPDX-License-Identifier: MIT
#pragma once

#include <functional>

#include "fdebench/reference/linear/closed_forms/closed_form.hpp"
#include "fdebench/reference/linear/transfer_functions/linear_transform.hpp"

namespace fde::reference {

// The outputs of a linear problem by inverse Laplace transform: residues at the zeros of the denominator on
// the principal sheet, and a parabolic contour around the branch cut on the negative axis. At t = 0 and where
// a load starts, the value is the limit from the right, which may be infinite.
//   In double: error at most 5e-16 max(|x|, |t x'|), about the effect of the rounding of t, with a bound.
//   In digits: relative accuracy of each value, down to 1e-40 of its summands.
// transform() is called at the first evaluation, not before. name is the prefix of the messages. Evaluating
// throws std::runtime_error where not all zeros are found or a value oscillates too fast to be computed.
Evaluation linear_evaluation(const char* name, std::function<LinearTransform()> transform);

// The Reference of an evaluation; at() also throws std::runtime_error where a finite value has no finite
// bound.
Reference linear_reference(const Evaluation& evaluation);
Reference linear_reference(const char* name, const std::function<LinearTransform()>& transform);

}  // namespace fde::reference
