#pragma once

#include <boost/multiprecision/mpfr.hpp>
#include <vector>

#include "start_weights/start_weights.hpp"

namespace fde {

// The numbers in which start weights are made, and the power series and matrices in them that it takes.
using Number = boost::multiprecision::number<
    boost::multiprecision::mpfr_float_backend<start_weight_digits, boost::multiprecision::allocate_stack>,
    boost::multiprecision::et_off>;
using Numbers1 = std::vector<Number>;
using Numbers2 = std::vector<Numbers1>;

// j^power for j = 0 ... last, 0^0 = 1.
Numbers1 powers_of_whole_numbers(double power, std::size_t last);

// zeta(-p), zeta(-p-1), ..., so many, by the sum formula of Euler and Maclaurin; from the powers j^p with j
// <= 32.
Numbers1 zeta_values(double p, const Numbers1& powers, std::size_t count);

// Series are their coefficients of 1, t, t^2, ...

// (a_0 + a_1 t + ...)^exponent with a_0 > 0.
Numbers1 power_of_series(const Numbers1& a, const Number& exponent);

// As many terms as a has.
Numbers1 product(const Numbers1& a, const Numbers1& b);

// The polynomial p(exp(-t)).
Numbers1 at_exponential(const Numbers1& p, std::size_t terms);

// (1 - exp(-t)) / t
Numbers1 exponential_mean(std::size_t terms);

// By elimination with the largest pivot of each column.
Numbers2 inverse(Numbers2 a);

}  // namespace fde
