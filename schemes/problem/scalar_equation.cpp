#include "problem/scalar_equation.hpp"

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

}  // namespace fde
