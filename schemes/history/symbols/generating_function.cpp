// SPDX-License-Identifier: MIT
#include "fdebench/schemes/history/symbols/generating_function.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <numbers>
#include <vector>

namespace fde {

namespace {

struct Point {
  double p;
  ComplexValue log_f;
};

ComplexValue ratio(const Point& a, const Point& b) { return std::exp(b.log_f - a.log_f); }

bool close(const Point& a, const Point& b) {
  const ComplexValue r = ratio(a, b);
  return std::abs(r - 1.0) < 0.5 * std::min(1.0, std::abs(r));
}

double change_between(const std::function<ComplexValue(double)>& log_f, const Point& a, const Point& b,
                      int depth) {
  constexpr int deepest = 40;
  if (depth == deepest || std::isinf(a.log_f.real()) || std::isinf(b.log_f.real())) return NAN;
  const double p = 0.5 * (a.p + b.p);
  const Point middle{p, log_f(p)};
  if (close(a, b) && close(a, middle) && close(middle, b)) return std::arg(ratio(a, b));
  const double first = change_between(log_f, a, middle, depth + 1);
  return std::isnan(first) ? first : first + change_between(log_f, middle, b, depth + 1);
}

}  // namespace

ComplexValue difference_power(double order, ComplexValue log_zeta) {
  return std::pow(-exp_minus_one(log_zeta), order);
}

ComplexValue generating_function(const WeightTable& table, ComplexValue log_zeta) {
  const ComplexValue regular = regular_part(table, log_zeta);
  if (table.family->acts_on_increments) return difference_power(table.order - 1.0, log_zeta) / regular;
  return difference_power(-table.order, log_zeta) * regular;
}

ComplexValue regular_part(const WeightTable& table, ComplexValue log_zeta) {
  return table.family->regular_part(table.order, log_zeta);
}

ComplexValue log_determinant(const ComplexMatrix& matrix) {
  const Eigen::PartialPivLU<ComplexMatrix> lu(matrix);
  const double sign = lu.permutationP().determinant() > 0 ? 0.0 : std::numbers::pi;
  ComplexValue sum{0.0, sign};
  for (const ComplexValue pivot : lu.matrixLU().diagonal()) sum += std::log(pivot);
  return sum;
}

double argument_change(const std::function<ComplexValue(double p)>& log_f,
                       const std::vector<double>& points) {
  double turn = 0.0;
  Point last{points.front(), log_f(points.front())};
  for (std::size_t i = 1; i < points.size() && !std::isnan(turn); ++i) {
    const Point next{points[i], log_f(points[i])};
    turn += change_between(log_f, last, next, 0);
    last = next;
  }
  return turn;
}

void append_pieces(double end, int pieces, std::vector<double>& points) {
  const double begin = points.back();
  for (int i = 1; i <= pieces; ++i) points.push_back(begin + (end - begin) * i / pieces);
}

}  // namespace fde
