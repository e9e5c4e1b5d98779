#pragma once

#include <functional>

#include "problem/problem.hpp"
#include "symbols/generating_function.hpp"

namespace fde {

// The symbol of a scheme on D^(g_i) y_i = (A y)_i with steps of one length. With the generating functions
// Y(zeta) = sum_n y_n zeta^n of all steps and F of A y, y = K F + (something of the initial values), so that
// S F = data. A zero of det S with |zeta| < 1 is a mode: some data make y_n grow like |zeta|^(-n), times a
// power of n at a multiple zero. Where det S has no zero in |zeta| <= 1, y_n -> 0 (Wiener's theorem: Lubich,
// IMA J. Numer. Anal. 6 (1986)). As for generating_function the argument is log zeta.
//
// With K_w the diagonal of step factor times generating function of the weights w, g_i the order of row i, S
// is
//   implicit rules       I - A K
//   predict, evaluate,   I - A (K_a - k + k A K_b), a the trapezoidal weights, b the rectangle's, k the
//   correct, evaluate    step factor of a, the weight of the newest sample
// What is returned has its column i times (1-zeta)^g_i, which is no zero inside the circle, and is bounded.
// Schemes that split orders have the symbol of the split problem.
using Symbol = std::function<ComplexMatrix(ComplexValue log_zeta)>;

// Where the family weighs increments of y, K is the inverse 1 / ((1-zeta) W) times the step factor. A scheme
// that splits orders passes the split problem. Preconditions: linear(problem), no algebraic rows, no right
// derivatives.
Symbol implicit_symbol(const Problem& problem, const WeightFamily& family, double length);

// The same for a rule that is no convolution of f with one family: kernel_of makes (1-zeta)^g K, for steps of
// length 1, of each order.
using Kernel = std::function<ComplexValue(ComplexValue log_zeta)>;
Symbol implicit_symbol(const Problem& problem, const std::function<Kernel(double order)>& kernel_of,
                       double length);
Symbol predictor_corrector_symbol(const Problem& problem, double length);

}  // namespace fde
