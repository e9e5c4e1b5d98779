#pragma once

#include <Eigen/Core>
#include <functional>

#include "generating_function.hpp"
#include "problem.hpp"

namespace fde {

using ComplexMatrix = Eigen::MatrixXcd;

// The symbol of a scheme on D^(g_i) y_i = (A y)_i with steps of one length: the matrix M(zeta), |zeta| <= 1,
// for which the generating function Y(zeta) = sum_n y_n zeta^n of all steps solves M Y = (something of the
// initial values alone). A zero of det M inside the unit circle is a mode that grows like |zeta|^(-n). As for
// generating_function the argument is log zeta.
//
// With K_w the diagonal of step factor times generating function of the weights w, g_i the order of row i:
//   implicit rules       I - K A
//   predict, evaluate,   I - (K_a - k) A - k A K_b A, a the trapezoidal weights, b the rectangle's, k the
//   correct, evaluate    step factor of a, the weight of the newest sample
// Schemes that split orders have the symbol of the split problem.
using Symbol = std::function<ComplexMatrix(ComplexValue log_zeta)>;

// L1 is inverted for this: K is 1 / ((1-zeta) W) times its step factor. Of a scheme that splits orders, this
// takes the split problem, which has a linear_part.
Symbol implicit_symbol(const Problem& problem, WeightFamily family, double length);
Symbol predictor_corrector_symbol(const Problem& problem, double length);

}  // namespace fde
