// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/observers/independent_memory.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/special_functions/beta.hpp>
#include <cmath>
#include <stdexcept>

#include "fdebench/reference/nonlinear/quadrature/gauss.hpp"
#include "fdebench/schemes/problem/smoothness.hpp"

namespace fde::bench {
namespace {

constexpr int nodes_a_step = 10;  // full double precision one step away from the singularity
// On later steps the error is that for a smooth v: the cubics are accurate to (step)^(p-4).
constexpr int corrected_steps = 1024;

// (power of x, r): the cubic on [0, 1] that is 1 at x = r - 1 and 0 at the other three of -1, 0, 1, 2.
const Eigen::Matrix4d& cubics() {
  static const Eigen::Matrix4d coefficients = (Eigen::Matrix4d() << 0.0, 6.0, 0.0, 0.0,  //
                                               -2.0, -3.0, 6.0, -1.0,                    //
                                               3.0, -6.0, 3.0, 0.0,                      //
                                               -1.0, 3.0, -3.0, 1.0)
                                                  .finished() /
                                              6.0;
  return coefficients;
}

// (r, k): the r-th cubic, or its derivative, at the k-th node.
Matrix cubics_at(const reference::LongVec& nodes, bool derivative) {
  Matrix powers(4, nodes.size());
  for (Eigen::Index k = 0; k < nodes.size(); ++k) {
    const auto x = static_cast<double>(nodes[k]);
    if (derivative) {
      powers.col(k) << 0.0, 1.0, 2.0 * x, 3.0 * x * x;
    } else {
      powers.col(k) << 1.0, x, x * x, x * x * x;
    }
  }
  return cubics().transpose() * powers;
}

// Extrapolates the cubic through the next four values by one step backwards.
double extrapolate_cubic(double one, double two, double three, double four) {
  return 4.0 * (one + three) - 6.0 * two - four;
}

double of_power(double t, double power, bool derivative) {
  return derivative ? power * std::pow(t, power - 1.0) : std::pow(t, power);
}

void require(double order, const Grid& grid) {
  if (!(order > 0.0 && order < 2.0) || order == 1.0)
    throw std::invalid_argument(fmt::format("order = {}: must be a number in (0, 1) or (1, 2)", order));
  if (!grid.uniform())
    throw std::invalid_argument(fmt::format("grading = {}: must be 1, a uniform grid", grid.grading));
  if (grid.steps < IndependentMemoryRule::fewest_steps) {
    throw std::invalid_argument(
        fmt::format("steps = {}: must be at least {}", grid.steps, IndependentMemoryRule::fewest_steps));
  }
}

}  // namespace

IndependentMemoryRule::IndependentMemoryRule(const Grid& grid, double order,
                                             const std::vector<double>& powers)
    : grid_(grid),
      exponent_(std::ceil(order) - order - 1.0),
      of_derivative_(order > 1.0),
      scale_(std::pow(grid.step(), exponent_ + (of_derivative_ ? 0.0 : 1.0)) / std::tgamma(exponent_ + 1.0)),
      fit_(powers) {
  require(order, grid);
  make_rule();
  make_starts();
}

void IndependentMemoryRule::make_rule() {
  const int steps = grid_.steps;
  const auto legendre = reference::gauss_jacobi(nodes_a_step, 0);
  kernel_.resize(nodes_a_step, steps);
  for (int lag = 1; lag <= steps; ++lag) {
    for (int k = 0; k < nodes_a_step; ++k) {
      kernel_(k, lag - 1) = static_cast<double>(legendre.weights[k]) *
                            std::pow(static_cast<double>(lag - legendre.nodes[k]), exponent_);
    }
  }
  weights_ = cubics_at(legendre.nodes, of_derivative_) * kernel_;
  const auto jacobi = reference::gauss_jacobi(nodes_a_step, exponent_);
  weights_.col(0) = cubics_at(jacobi.nodes, of_derivative_) * jacobi.weights.cast<double>();

  // The value with index l = n - lag is node r - 1 of the step that begins lag + r - 1 steps back.
  reversed_ = Vec::Zero(steps + 1);
  for (int lag = 0; lag <= steps; ++lag) {
    for (int r = 0; r < 4; ++r) {
      const int back = lag + r - 1;
      if (back >= 1 && back <= steps) reversed_[steps - lag] += weights_(r, back - 1);
    }
  }
  next_weight_ = weights_(3, 0);
}

// t^power at steps -1, 0, ..., count + 1; outside the grid extrapolated as in `at`.
Vec IndependentMemoryRule::power_at_steps(double power, int count) const {
  Vec v(count + 3);
  for (int l = 0; l <= count + 1; ++l) v[l + 1] = std::pow(l, power);
  v[0] = extrapolate_cubic(v[1], v[2], v[3], v[4]);
  if (count == grid_.steps)
    v[count + 2] = extrapolate_cubic(v[count + 1], v[count], v[count - 1], v[count - 2]);
  return v;
}

void IndependentMemoryRule::make_starts() {
  const int count = std::min(grid_.steps, corrected_steps);
  const auto legendre = reference::gauss_jacobi(nodes_a_step, 0),
             jacobi = reference::gauss_jacobi(nodes_a_step, exponent_);
  const Matrix at_legendre = cubics_at(legendre.nodes, of_derivative_).transpose();
  const Matrix at_jacobi = cubics_at(jacobi.nodes, of_derivative_).transpose();
  const auto less_cubic = [&](double power, int step, const reference::LongVec& nodes, Vec cubic) -> Vec {
    for (Eigen::Index k = 0; k < nodes.size(); ++k)
      cubic[k] = of_power(step + static_cast<double>(nodes[k]), power, of_derivative_) - cubic[k];
    return cubic;
  };
  for (std::size_t p = 0; p < fit_.powers().size(); ++p) {
    const double power = fit_.powers()[p];
    if (is_integer_order(power) && power < 3.5) continue;  // the cubics are exact
    const Vec v = power_at_steps(power, count);
    PowerCorrection start{power, static_cast<Eigen::Index>(p), v.head<4>(), Matrix(nodes_a_step, count - 1),
                          Vec(count - 1)};
    for (int j = 1; j < count; ++j) {
      start.far.col(j - 1) = less_cubic(power, j, legendre.nodes, at_legendre * v.segment<4>(j));
      start.near[j - 1] =
          jacobi.weights.cast<double>().dot(less_cubic(power, j, jacobi.nodes, at_jacobi * v.segment<4>(j)));
    }
    const auto first = reference::gauss_jacobi(nodes_a_step, of_derivative_ ? power - 1.0 : power);
    start.first_nodes = (1 - first.nodes.array()).cast<double>();
    start.first_weights = first.weights.cast<double>() * (of_derivative_ ? power : 1.0);
    starts_.push_back(std::move(start));
  }
}

// int_0^(t_n) (t_n - s)^(b-1) (s^p - its cubics) ds, in units of the step size.
double IndependentMemoryRule::start_error(const PowerCorrection& start, int n) const {
  double exact = 0.0;
  if (n == 1) {
    exact = of_derivative_ ? start.power * boost::math::beta(start.power, exponent_ + 1.0)
                           : boost::math::beta(start.power + 1.0, exponent_ + 1.0);
  } else {
    exact = (start.first_weights.array() * (n - start.first_nodes.array()).pow(exponent_)).sum();
  }
  double error = exact - weights_.col(n - 1).dot(start.values);
  const int count = static_cast<int>(std::min<Eigen::Index>(n - 2, start.far.cols()));
  for (int j = 1; j <= count; ++j) error += start.far.col(j - 1).dot(kernel_.col(n - j - 1));
  if (n >= 2 && n - 1 <= start.near.size()) error += start.near[n - 2];
  return error;
}

double IndependentMemoryRule::at(int n, const Vec& velocities) const {
  const Vec& v = velocities;
  const int steps = grid_.steps;
  double sum = reversed_.segment(steps - n + 2, n - 1).dot(v.segment(2, n - 1));
  sum += next_weight_ *
         (n < steps ? v[n + 1] : extrapolate_cubic(v[steps], v[steps - 1], v[steps - 2], v[steps - 3]));
  for (int l = -1; l <= 1; ++l) {  // values that belong to no step before 0
    const double value = l < 0 ? extrapolate_cubic(v[0], v[1], v[2], v[3]) : v[l];
    for (int r = 0; r <= l + 1; ++r) {
      const int back = n - l + r - 1;
      if (back >= 1) sum += weights_(r, back - 1) * value;
    }
  }
  const Vec coefficients = fit_.coefficients(v);
  for (const auto& start : starts_) sum += coefficients[start.row] * start_error(start, n);
  return scale_ * sum;
}

}  // namespace fde::bench
