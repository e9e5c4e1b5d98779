// SPDX-License-Identifier: MIT
#pragma once

#include <functional>

#include "fdebench/schemes/history/symbols/generating_function.hpp"
#include "fdebench/schemes/history/symbols/symbol.hpp"
#include "fdebench/schemes/problem/problem.hpp"

namespace fde {

// The symbol of an implicit rule with this step size. For weights of increments of y, K is 1 / ((1-zeta) W)
// times the step factor. A scheme that splits orders passes the split problem. Preconditions:
// is_linear(problem), no algebraic rows, no right derivatives.
Symbol implicit_symbol(const Problem& problem, const WeightFamily& family, double length);

// The same for a rule that is not a convolution of f with one family: kernel_of(g) is (1-zeta)^g K for order
// g and step size 1, and f of this order is evaluated at t_(n-1) + offset_of(g) h, on the line from y_(n-1)
// to y_n.
using Kernel = std::function<ComplexValue(ComplexValue log_zeta)>;
Symbol implicit_symbol(
    const Problem& problem, const std::function<Kernel(double order)>& kernel_of, double length,
    const std::function<double(double order)>& offset_of = [](double) { return 1.0; });

// The symbol of the predictor-corrector rule with one correction. Preconditions as above.
Symbol predictor_corrector_symbol(const Problem& problem, double length);

}  // namespace fde
