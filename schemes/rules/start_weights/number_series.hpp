// SPDX-License-Identifier: MIT
#pragma once

#include <boost/multiprecision/mpfr.hpp>
#include <vector>

#include "fdebench/schemes/rules/start_weights/start_weights.hpp"

namespace fde {

// The multiprecision numbers in which starting weights are computed, with power series and matrices of them.
using Number = boost::multiprecision::number<
    boost::multiprecision::mpfr_float_backend<starting_weight_digits, boost::multiprecision::allocate_stack>,
    boost::multiprecision::et_off>;
using NumberVector = std::vector<Number>;
using NumberMatrix = std::vector<NumberVector>;

// j^power for j = 0 ... last, 0^0 = 1.
NumberVector integer_powers(double power, std::size_t last);

// zeta(-p), zeta(-p-1), ..., `count` values, by the Euler-Maclaurin formula. powers[j] = j^p for j <= 32.
NumberVector zeta_values(double p, const NumberVector& powers, std::size_t count);

// A power series is given by its coefficients of 1, t, t^2, ...

// (a_0 + a_1 t + ...)^exponent. Precondition: a_0 > 0.
NumberVector power_of_series(const NumberVector& a, const Number& exponent);

// The product a b, with as many terms as a. Precondition: b has at least as many.
NumberVector product(const NumberVector& a, const NumberVector& b);

// The series of the polynomial p at exp(-t).
NumberVector compose_with_exponential(const NumberVector& p, std::size_t terms);

// The series of (1 - exp(-t)) / t.
NumberVector exponential_mean(std::size_t terms);

// The inverse matrix, by Gauss-Jordan elimination with partial pivoting. Precondition: a is regular.
NumberMatrix inverse(NumberMatrix a);

}  // namespace fde
