// SPDX-License-Identifier: MIT
#include "fdebench/reference/nonlinear/march/rhs_noise.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace fde::reference {

namespace {

constexpr double largest_noise = 1e-12;  // relative to the scale
constexpr double matters = 1.0 / 16;     // relative to `negligible`
constexpr double safety = 2.0;

// Each number or one of its neighbours.
Vec perturbed(const Vec& y, std::minstd_rand& generator) {
  constexpr double rounding = std::numeric_limits<double>::epsilon();
  constexpr unsigned low_bits = 7;  // of poor quality in this generator
  return y.unaryExpr([&](double value) {
    return value * (1.0 + rounding * (static_cast<double>((generator() >> low_bits) % 3) - 1.0));
  });
}

}  // namespace

Vec rhs_noise(const Problem& problem, double from, In y_from, double to, In y_to) {
  constexpr Eigen::Index intervals = 16, order = 10;
  constexpr double gain =
      429.8;  // for independent errors: the square root of the binomial coefficient (20, 10)
  Matrix values(intervals + 1, problem.size());
  Vec f(problem.size());
  std::minstd_rand generator(5);
  for (Eigen::Index k = 0; k <= intervals; ++k) {
    const double share = static_cast<double>(k) / intervals;
    problem.rhs(from + share * (to - from), perturbed(y_from + share * (y_to - y_from), generator), f);
    values.row(k) = f.transpose();
  }
  for (Eigen::Index k = 0; k < order; ++k) {
    values = (values.bottomRows(values.rows() - 1) - values.topRows(values.rows() - 1)).eval();
  }
  if (!values.allFinite()) return Vec::Zero(problem.size());
  return values.cwiseAbs().colwise().maxCoeff().transpose() / gain;
}

Vec RhsNoise::largest(const Vec& times, const Matrix& y) const {
  constexpr Eigen::Index lines = 5;
  const Eigen::Index stride = std::max<Eigen::Index>(1, (times.size() - 1) / lines);
  Vec noise = Vec::Zero(problem_.size());
  for (Eigen::Index k = 0; k + 1 < times.size(); k += stride) {
    noise = noise.cwiseMax(
        rhs_noise(problem_, times[k], y.row(k).transpose(), times[k + 1], y.row(k + 1).transpose()));
  }
  return noise;
}

bool RhsNoise::detect(const Vec& times, const Matrix& y, In unresolved, In negligible, double scale) {
  constexpr double explains = 32.0;
  const auto suspected =
      (unresolved.array() > matters * negligible.array() && unresolved.array() <= largest_noise * scale)
          .eval();
  if (!suspected.any()) return false;
  const Vec noise = largest(times, y);
  bool news = false;
  for (Eigen::Index i = 0; i < noise.size(); ++i) {
    if (suspected[i] && noise[i] > allowance_[i] && noise[i] > matters * negligible[i] &&
        noise[i] <= largest_noise * scale && explains * noise[i] >= unresolved[i]) {
      allowance_[i] = safety * noise[i];
      news = true;
    }
  }
  return news;
}

void RhsNoise::update_after_step(const Vec& times, const Matrix& y, In explained) {
  if (allowance_.isZero(0.0)) return;
  const Vec noise = largest(times, y);
  for (Eigen::Index i = 0; i < allowance_.size(); ++i) {
    if (allowance_[i] == 0.0) continue;
    const double allowance = noise[i] > explained[i] ? safety * noise[i] : 0.0;
    const double faded = allowance_[i] > explained[i] ? allowance_[i] / 2 : 0.0;
    allowance_[i] = std::clamp(allowance, faded, allowance_[i]);
  }
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
