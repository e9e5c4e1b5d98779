#pragma once

#include <boost/multiprecision/mpfr.hpp>
#include <vector>

#include "start_weights/start_weights.hpp"

namespace fde {

// The multiprecision numbers in which starting weights are computed, with power series and matrices of them.
using Number = boost::multiprecision::number<
    boost::multiprecision::mpfr_float_backend<start_weight_digits, boost::multiprecision::allocate_stack>,
    boost::multiprecision::et_off>;
using Numbers1 = std::vector<Number>;
using Numbers2 = std::vector<Numbers1>;

// j^power for j = 0 ... last, 0^0 = 1.
Numbers1 powers_of_whole_numbers(double power, std::size_t last);

// zeta(-p), zeta(-p-1), ..., `count` values, by the Euler-Maclaurin formula. powers[j] = j^p for j <= 32.
Numbers1 zeta_values(double p, const Numbers1& powers, std::size_t count);

// A power series is given by its coefficients of 1, t, t^2, ...

// (a_0 + a_1 t + ...)^exponent. Precondition: a_0 > 0.
Numbers1 power_of_series(const Numbers1& a, const Number& exponent);

// The product a b, with as many terms as a. Precondition: b has at least as many.
Numbers1 product(const Numbers1& a, const Numbers1& b);

// The series of the polynomial p at exp(-t).
Numbers1 at_exponential(const Numbers1& p, std::size_t terms);

// The series of (1 - exp(-t)) / t.
Numbers1 exponential_mean(std::size_t terms);

// The inverse matrix, by Gauss-Jordan elimination with partial pivoting. Precondition: a is regular.
Numbers2 inverse(Numbers2 a);

}  // namespace fde
