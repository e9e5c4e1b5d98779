// SPDX-License-Identifier: MIT
#include "fdebench/schemes/problem/scalar_equation.hpp"

#include "fdebench/schemes/problem/chain.hpp"
#include "fdebench/schemes/problem/delays.hpp"

namespace fde {

Problem scalar_equation(double order, std::complex<double> rate, double end) {
  const bool real = rate.imag() == 0.0;
  const double x = rate.real(), y = rate.imag();
  const Matrix matrix = real ? Matrix::Constant(1, 1, x) : (Matrix(2, 2) << x, -y, y, x).finished();
  std::vector<double> start(initial_count(order), 0.0);
  start.front() = 1.0;
  return {.components = std::vector<Component>(real ? 1 : 2, {order, start}),
          .rhs = [=](double, In u, Out f) { f = matrix * u; },
          .derivatives = DenseLinearPart{matrix},
          .end = end};
}

Problem delayed_equation(double order, double rate, double delayed_rate, double lag, double end) {
  Problem problem = scalar_equation(order, rate, end);
  problem.rhs = {};
  problem.delays = linear_delays({lag}, Matrix::Constant(1, 1, rate), {Matrix::Constant(1, 1, delayed_rate)},
                                 Vec::Ones(1));
  return problem;
}

Problem scalar_multi_term_equation(double order, std::complex<double> rate, double end) {
  const bool real = rate.imag() == 0.0;
  const double x = rate.real(), y = rate.imag();
  std::vector<double> start(initial_count(order), 0.0);
  const Chain imaginary({1.0, order}, {}, start, std::ssize(start));
  start.front() = 1.0;
  const Chain first({1.0, order}, {}, start);
  if (real) {
    return chain_problem(
        {{.chain = first, .force = [=](double, In u) { return x * u[0]; }, .derivatives = LinearForce{x}}},
        end);
  }
  const auto i = imaginary.first_row();
  Problem problem =
      chain_problem({{.chain = first, .force = [=](double, In u) { return x * u[0] - y * u[i]; }},
                     {.chain = imaginary, .force = [=](double, In u) { return y * u[0] + x * u[i]; }}},
                    end);
  DenseLinearPart part{Matrix::Zero(2 * i, 2 * i)};
  part.matrix.diagonal(1).setOnes();
  part.matrix.row(i - 1).setZero();
  part.matrix(i - 1, 0) = part.matrix(2 * i - 1, i) = x;
  part.matrix(2 * i - 1, 0) = y;
  part.matrix(i - 1, i) = -y;
  problem.derivatives = part;
  return problem;
}

}  // namespace fde
