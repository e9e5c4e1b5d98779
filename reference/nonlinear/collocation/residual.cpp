// SPDX-License-Identifier: MIT
#include "fdebench/reference/nonlinear/collocation/residual.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <deque>
#include <stdexcept>
#include <utility>
#include <vector>

#include "fdebench/reference/nonlinear/march/march_limits.hpp"
#include "fdebench/reference/nonlinear/march/rhs_noise.hpp"

namespace fde::reference {

namespace {

constexpr double of_sums = 1e-13;  // rounding, relative

// Polynomials on [0, 1] as sums of Legendre polynomials P_k(2x - 1): one row a degree, one column each.
class Polynomials {
 public:
  explicit Polynomials(Matrix coefficients)
      : coefficients_(std::move(coefficients)), curvature_(Vec::Zero(coefficients_.cols())) {
    // |P_k''| <= (k-1) k (k+1) (k+2) / 8 on [-1, 1].
    for (Eigen::Index k = 0; k < coefficients_.rows(); ++k) {
      const auto degree = static_cast<double>(k);
      const double largest = (degree - 1.0) * degree * (degree + 1.0) * (degree + 2.0) / 2.0;
      curvature_ += largest * coefficients_.row(k).cwiseAbs().transpose();
    }
  }

  // Values and derivatives at x.
  [[nodiscard]] std::pair<Vec, Vec> at(double x) const {
    const Eigen::Index count = coefficients_.rows();
    const double z = 2.0 * x - 1.0;
    Vec p = Vec::Zero(count), slope = Vec::Zero(count);
    for (Eigen::Index k = 0; k < count; ++k) {
      const auto n = static_cast<double>(k);
      p[k] = k == 0 ? 1.0 : k == 1 ? z : ((2.0 * n - 1.0) * z * p[k - 1] - (n - 1.0) * p[k - 2]) / n;
      if (k > 0) slope[k] = n * p[k - 1] + z * slope[k - 1];
    }
    return {coefficients_.transpose() * p, 2.0 * (coefficients_.transpose() * slope)};
  }

  // Ranges on [from, to], by Taylor's formula at the middle.
  void ranges(double from, double to, std::vector<Interval>& found) const {
    const double radius = (to - from) / 2.0;
    const auto [value, slope] = at(from + radius);
    for (Eigen::Index i = 0; i < value.size(); ++i) {
      const double most = radius * std::abs(slope[i]) + radius * radius / 2.0 * curvature_[i] +
                          of_sums * coefficients_.col(i).cwiseAbs().sum();
      found[static_cast<std::size_t>(i)] = {value[i] - most, value[i] + most};
    }
  }

 private:
  Matrix coefficients_;
  Vec curvature_;  // bound of the second derivatives
};

// What a residual of row i on a panel is small against: the terms of f_i, the y_i that it would change, and
// the rounding of f_i, as large as at later times where a solution is at rest at first.
struct Scales {
  Vec terms, sizes, rounding;
};

class ResidualTest {
 public:
  ResidualTest(const Problem& problem, const PiecewiseSolution& solution)
      : problem_(problem), solution_(solution), basis_(solution.basis()) {
    const Eigen::Index count = basis_.dense_nodes.size();
    Matrix legendre(count, count);
    for (Eigen::Index j = 0; j < count; ++j) {
      Matrix unit = Matrix::Identity(count, count);
      legendre.row(j) = Polynomials(unit).at(basis_.dense_nodes[j]).first.transpose();
    }
    analysis_ = legendre.inverse();
    constexpr double begun = 1e-3;  // of the end: f may be infinite at 0
    Vec largest = Vec::Zero(problem.size());
    for (const Panel& panel : solution.panels()) {
      if (panel.to >= begun * problem.end)
        rounding_ = rounding_.cwiseMax(of_sums * panel.rhs.cwiseAbs().colwise().maxCoeff().transpose());
      largest = largest.cwiseMax(panel.values.cwiseAbs().colwise().maxCoeff().transpose());
      peaks_.push_back(largest);
    }
  }

  void examine() const {
    for (const Panel& panel : solution_.panels()) {
      const Polynomials y(analysis_ * panel.values), f(basis_.legendre * panel.rhs);
      const Scales scales = scales_on(panel);
      if (solution_.is_resolved(panel)) examine_points(panel, y, f, scales);
      // After a jump a transient may be over before the next double. There the root is followed instead.
      if (problem_.range && !jumps_at(problem_, panel.from)) examine_everywhere(panel, y, f, scales);
    }
  }

 private:
  static constexpr double coarse = 0.05, fine = 1e-6;

  [[noreturn]] static void reject(Eigen::Index row, double t, double residual) {
    throw std::runtime_error(
        fmt::format("collocation: its solution does not satisfy row {} at t = {:.10g}: the residual there is "
                    "{:.3g}",
                    row + 1, t, residual));
  }

  [[nodiscard]] Scales scales_on(const Panel& panel) const {
    constexpr double soon = 4.0;  // a solution that starts at rest is small at first
    const double later = std::min(std::max(soon * panel.to, solution_.unresolved_until()), problem_.end);
    constexpr double several = 100.0;  // coefficients, and values of polynomials of rounded ones
    Scales scales{Vec::Zero(problem_.size()), peaks_[solution_.panel_of(later)],
                  rounding_.cwiseMax(several * panel.negligible)};
    Matrix jacobian(problem_.size(), problem_.size());
    for (Eigen::Index k = 0; k < basis_.points(); ++k) {
      const double t = panel.from + panel.length() * basis_.nodes[k];
      const Vec value = panel.values.row(k + 1).transpose();
      Vec terms = panel.rhs.row(k).transpose().cwiseAbs();
      if (evaluate_jacobian(problem_, t, value, jacobian)) terms += jacobian.cwiseAbs() * value.cwiseAbs();
      scales.terms = scales.terms.cwiseMax(terms);
    }
    return scales;
  }

  // The change of y_i up to the end by a residual 1 in row i during this length before t.
  [[nodiscard]] double effect(Eigen::Index i, double length, double t) const {
    const double order = problem_.component(i).order;
    const double lever = order > 1.0 ? std::max(length, problem_.end - t) : length;
    return length * std::pow(lever, order - 1.0) / std::tgamma(order + 1.0);
  }

  [[nodiscard]] bool is_examined(Eigen::Index i) const { return !problem_.is_algebraic(i); }

  [[nodiscard]] bool is_small(Eigen::Index i, double residual, double length, double t, const Scales& scales,
                              double part) const {
    constexpr double nothing = 1e-300;
    return residual <= nothing || residual <= part * scales.terms[i] || residual <= scales.rounding[i] ||
           residual * effect(i, length, t) <= part * scales.sizes[i];
  }

  [[nodiscard]] Vec residual_at(const Panel& panel, const Polynomials& y, const Polynomials& f,
                                double x) const {
    const double t = node_times(problem_, panel.from, panel.length(), Vec::Constant(1, x))[0];
    return rhs_at(problem_, t, y.at(x).first) - f.at(x).first;
  }

  void examine_points(const Panel& panel, const Polynomials& y, const Polynomials& f,
                      const Scales& scales) const {
    const auto points = static_cast<int>(3 * basis_.points());
    for (int k = 0; k < points; ++k) {
      const double x = (k + 0.5) / points;
      const Vec residual = residual_at(panel, y, f, x).cwiseAbs();
      for (Eigen::Index i = 0; i < residual.size(); ++i) {
        if (is_examined(i) && !is_small(i, residual[i], panel.length(), panel.to, scales, fine))
          reject(i, panel.from + x * panel.length(), residual[i]);
      }
    }
  }

  // What rounding alone adds to the ranges of f on a panel: terms may cancel for every y.
  [[nodiscard]] Vec rounding_of_ranges(const Panel& panel, const Polynomials& y) const {
    constexpr double several = 4.0;
    const auto size = static_cast<std::size_t>(problem_.size());
    std::vector<Interval> values(size), rhs(size);
    Vec widths = Vec::Zero(problem_.size());
    for (const double x : {0.5, 1.0}) {
      y.ranges(x, x, values);
      const double t = node_times(problem_, panel.from, panel.length(), Vec::Constant(1, x))[0];
      problem_.range(t, values, rhs);
      for (std::size_t i = 0; i < size; ++i) {
        // Where no range of f is known, nothing is rounding: the middles of pieces decide.
        double& widest = widths[static_cast<Eigen::Index>(i)];
        if (std::isfinite(rhs[i].width())) widest = std::max(widest, several * rhs[i].width());
      }
    }
    return widths;
  }

  // A bound of the residual of each row on a piece of a panel.
  [[nodiscard]] Vec bound_on(const Panel& panel, const Polynomials& y, const Polynomials& f, double from,
                             double to) const {
    const auto size = static_cast<std::size_t>(problem_.size());
    std::vector<Interval> values(size), taken(size), rhs(size);
    y.ranges(from, to, values);
    f.ranges(from, to, taken);
    const Vec times = node_times(problem_, panel.from, panel.length(), Vec{{from, to}});
    problem_.range({times[0], times[1]}, values, rhs);
    Vec bound(problem_.size());
    for (std::size_t i = 0; i < size; ++i)
      bound[static_cast<Eigen::Index>(i)] = (rhs[i] - taken[i]).magnitude();
    return bound;
  }

  // Divides the panel, the longest piece first. The pieces that remain cover a time so short that what they
  // may change is small; or ranges overestimate f on them, because its terms cancel, and the residual at
  // their middles decides.
  void examine_everywhere(const Panel& panel, const Polynomials& y, const Polynomials& f,
                          Scales scales) const {
    scales.rounding = scales.rounding.cwiseMax(rounding_of_ranges(panel, y));
    constexpr int most_pieces = 4000;
    constexpr double shortest = 0x1p-50;
    std::deque<std::pair<double, double>> open{{0.0, 1.0}};
    for (int pieces = 1; !open.empty() && pieces < most_pieces; ++pieces) {
      const auto [from, to] = open.front();
      if (to - from <= shortest) break;
      open.pop_front();
      const Vec bound = bound_on(panel, y, f, from, to);
      bool small = true;
      for (Eigen::Index i = 0; i < bound.size(); ++i)
        small = small && (!is_examined(i) || is_small(i, bound[i], panel.length(), panel.to, scales, coarse));
      if (small) continue;
      open.emplace_back(from, (from + to) / 2.0);
      open.emplace_back((from + to) / 2.0, to);
    }
    double time = 0.0;
    Vec bound = Vec::Zero(problem_.size()), found = bound;
    for (const auto& [from, to] : open) {
      Vec most = bound_on(panel, y, f, from, to);
      // f may be infinite at 0, as t^(-1/2) is, or a quotient 0/0: a piece that contains 0 has no bound then.
      if (panel.from == 0.0 && from == 0.0)
        most = most.unaryExpr([](double one) { return std::isfinite(one) ? one : 0.0; });
      bound = bound.cwiseMax(most);
      found = found.cwiseMax(residual_at(panel, y, f, (from + to) / 2.0).cwiseAbs());
      time += (to - from) * panel.length();
    }
    for (Eigen::Index i = 0; i < bound.size(); ++i) {
      if (time == 0.0 || !is_examined(i) || bound[i] <= scales.rounding[i]) continue;
      const double change = effect(i, time, panel.to), allowed = coarse * scales.sizes[i];
      if (!(bound[i] * change <= allowed) && !(found[i] <= scales.rounding[i]) &&
          !(found[i] * change <= allowed))
        reject(i, panel.from + open.front().first * panel.length(), found[i]);
    }
  }

  const Problem& problem_;
  const PiecewiseSolution& solution_;
  const PanelBasis& basis_;
  Matrix analysis_;  // Legendre coefficients from the values at dense_nodes
  Vec rounding_ = Vec::Zero(problem_.size());
  std::vector<Vec> peaks_{};  // the largest |y_i| up to the end of each panel
};

}  // namespace

void require_small_residual(const Problem& problem, const PiecewiseSolution& solution) {
  ResidualTest(problem, solution).examine();
}

}  // namespace fde::reference
