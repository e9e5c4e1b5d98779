// SPDX-License-Identifier: MIT
#include "fdebench/reference/nonlinear/march/rhs_at.hpp"

#include <cmath>

namespace fde::reference {

Vec rhs_at(const Problem& problem, double t, In y) {
  Vec f(problem.size());
  problem.rhs(t, y, f);
  return f;
}

Matrix rhs_at(const Problem& problem, const Vec& times, const Matrix& y) {
  Matrix rhs(times.size(), problem.size());
  for (Eigen::Index k = 0; k < times.size(); ++k) {
    rhs.row(k) = rhs_at(problem, times[k], y.row(k).transpose()).transpose();
  }
  return rhs;
}

Vec rounding_of_times(const Problem& problem, double from, const Vec& times, const Matrix& y,
                      const Matrix& rhs) {
  const Vec moved = times.unaryExpr([&](double t) { return std::nextafter(t, from); });
  return (rhs_at(problem, moved, y) - rhs).cwiseAbs().colwise().maxCoeff();
}

Vec largest_forcing(const Problem& problem) {
  constexpr int samples = 64, within = 8;
  const Vec initial = taylor_part(problem, 0.0);
  Vec largest = Vec::Zero(problem.size());
  const auto add = [&](double from, double to, int count) {
    for (int k = 0; k <= count; ++k) {
      const Vec f = rhs_at(problem, from + (to - from) * k / count, initial).cwiseAbs();
      if (f.allFinite()) largest = largest.cwiseMax(f);
    }
  };
  add(0.0, problem.end, samples);
  for (const auto& limit : problem.step_limits) add(limit.from, limit.to, within);
  return largest;
}

}  // namespace fde::reference
