#pragma once

#include <functional>

#include "evaluation/evaluation.hpp"
#include "transfer_functions/linear_transform.hpp"

namespace fde {

// The outputs of a linear problem: inverse Laplace transform with residues at the zeros
// of the denominator on the principal sheet and a parabolic contour round the branch cut on the negative
// axis. Where something sets in, and at t = 0, the value is the limit from the right, which may be infinite.
//   In double: within 5e-16 of max(|x|, |t x'|), about what the rounding of t does to it, and its bound.
//   In digits: relative accuracy of each value, down to 1e-40 of the terms it is the sum of.
// The transform is made when a value is first asked for; it need not be valid before. name begins the
// messages. Evaluating throws std::runtime_error where the zeros cannot all be found.
Evaluation linear_evaluation(const char* name, std::function<LinearTransform()> transform);

// As a reference; at() throws std::runtime_error, too, where a finite value has no finite bound.
Reference linear_reference(const Evaluation& evaluation);
Reference linear_reference(const char* name, std::function<LinearTransform()> transform);

}  // namespace fde
