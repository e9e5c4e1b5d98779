// SPDX-License-Identifier: MIT
#include "fdebench/schemes/rules/two_sided/panel_side.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

#include "fdebench/schemes/history/weights/kernel_moments.hpp"
#include "fdebench/schemes/problem/progress/progress.hpp"
#include "fdebench/schemes/rules/spectral/panel_rule.hpp"

namespace fde {
namespace {

// A step of Newton's method to the zeros of P_n, with the slope n (x P_n - P_(n-1)) / (x^2 - 1).
void improve_legendre_points(Vec& x) {
  const auto count = x.size();
  const Matrix p = legendre_polynomials(x, count + 1);
  const auto highest = p.col(count).array(), lower = p.col(count - 1).array();
  x.array() -=
      highest * (x.array().square() - 1.0) / (static_cast<double>(count) * (x.array() * highest - lower));
}

}  // namespace

LegendrePoints::LegendrePoints(Eigen::Index count)
    : points(Vec::NullaryExpr(count, [&](Eigen::Index i) {
        return -std::cos((static_cast<double>(i) + 0.75) * std::numbers::pi /
                         (static_cast<double>(count) + 0.5));
      })) {
  constexpr int steps = 4;  // to rounding; each squares the error
  for (int step = 0; step < steps; ++step) improve_legendre_points(points);
  points = (points - points.reverse()).eval() / 2.0;
  const Matrix p = legendre_polynomials(points, count);
  const auto lower = static_cast<double>(count) * p.col(count - 1).array();
  // Half the weights of Gauss's rule, which is exact for products of the polynomials.
  const Vec weights = (1.0 - points.array().square()) / lower.square();
  const Vec norms = Vec::LinSpaced(count, 1.0, 2.0 * static_cast<double>(count) - 1.0);
  to_coefficients = norms.asDiagonal() * p.transpose() * weights.asDiagonal();
}

// Newton's equations panel by panel: on each, all points of all rows at once.
class PanelSide::Factors final : public SideFactors {
 public:
  Factors(const PanelSide& side, const Matrix& jacobians) : side_(side), jacobians_(jacobians) {
    const auto n = side.points(), rows = std::ssize(side.rows_);
    for (Eigen::Index k = 0; k < side.panels(); ++k) {
      Matrix all = Matrix::Zero(n * rows, n * rows);
      for (const auto& integrals : side.integrals_) {
        const auto own = integrals.weights.block(k * n, k * n, n, n);
        for (const auto i : integrals.rows) {
          all.block(i * n, i * n, n, n).setIdentity();
          for (Eigen::Index j = 0; j < rows; ++j)
            all.block(i * n, j * n, n, n) -= own * slopes(k, i, j).asDiagonal();
        }
      }
      for (Eigen::Index i = side.differential_count_; i < rows; ++i) {
        for (Eigen::Index j = 0; j < rows; ++j) all.block(i * n, j * n, n, n).diagonal() = -slopes(k, i, j);
      }
      factors_.emplace_back(all);
    }
    Matrix at_end = Matrix::Identity(rows, rows);
    for (Eigen::Index i = side.differential_count_; i < rows; ++i) {
      for (Eigen::Index j = 0; j < rows; ++j) at_end(i, j) = -slope(side.last_, i, j);
    }
    at_end_.compute(at_end);
  }

  void solve(const Rows& given, Rows& y) const override {
    if (side_.empty()) return;
    report_progress(0);
    const auto n = side_.points(), rows = std::ssize(side_.rows_), last = side_.last_;
    const auto start = side_.column(0);
    for (const auto i : side_.rows_) y(i, start) = given(i, start);
    // g = J y at all points, first of the rows of the other side alone
    for (Eigen::Index m = 1; m <= last; ++m) {
      for (const auto i : side_.rows_) y(i, side_.column(m)) = 0.0;
    }
    Rows g(rows, last);
    for (Eigen::Index m = 1; m <= last; ++m) g.col(m - 1) = product(m, y);
    const Rows right = side_.own(given);
    for (Eigen::Index k = 0; k < side_.panels(); ++k) {
      Rows known = right.middleCols(k * n, n);
      for (const auto& integrals : side_.integrals_) {
        const auto before = integrals.weights.block(k * n, 0, n, (k + 1) * n);
        const Rows of_order = g(integrals.rows, Eigen::seqN(0, (k + 1) * n));
        known(integrals.rows, Eigen::all) += of_order * before.transpose();
      }
      known.bottomRows(rows - side_.differential_count_) +=
          g.block(side_.differential_count_, k * n, rows - side_.differential_count_, n);
      set_panel(k, known, y);
      for (Eigen::Index m = k * n + 1; m <= (k + 1) * n; ++m) g.col(m - 1) = product(m, y);
    }
    Vec at_end = right.col(last - 1);
    for (const auto& integrals : side_.integrals_) {
      for (const auto i : integrals.rows)
        at_end[i] += g.row(i).head(last - 1).dot(integrals.weights.row(last - 1));
    }
    const auto algebraic = rows - side_.differential_count_;
    at_end.tail(algebraic) += g.col(last - 1).tail(algebraic);
    set(last, at_end_.solve(at_end), y);
  }

  // The solution of each panel without the others.
  void solve_block_diagonal(const Rows& given, Rows& y) const override {
    if (side_.empty()) return;
    const auto n = side_.points();
    for (const auto i : side_.rows_) y(i, side_.column(0)) = given(i, side_.column(0));
    const Rows right = side_.own(given);
    for (Eigen::Index k = 0; k < side_.panels(); ++k) set_panel(k, right.middleCols(k * n, n), y);
    set(side_.last_, at_end_.solve(right.col(right.cols() - 1)), y);
  }

  [[nodiscard]] std::size_t bytes() const override {
    const auto size = side_.points() * std::ssize(side_.rows_);
    return sizeof(double) * factors_.size() * static_cast<std::size_t>(size * size);
  }

 private:
  void set(Eigen::Index m, const Vec& values, Rows& y) const {
    for (std::size_t i = 0; i < side_.rows_.size(); ++i)
      y(side_.rows_[i], side_.column(m)) = values[static_cast<Eigen::Index>(i)];
  }
  // Sets the rows of a panel to the solution for these right-hand sides, one row each.
  void set_panel(Eigen::Index k, const Rows& right, Rows& y) const {
    const auto n = side_.points();
    const Vec solved = factors_[static_cast<std::size_t>(k)].solve(Matrix(right.transpose()).reshaped());
    const auto values = solved.reshaped(n, std::ssize(side_.rows_));
    for (Eigen::Index p = 0; p < n; ++p) set(k * n + p + 1, values.row(p).transpose(), y);
  }
  [[nodiscard]] auto jacobian(Eigen::Index m) const {
    const auto size =
        static_cast<Eigen::Index>(std::lround(std::sqrt(static_cast<double>(jacobians_.rows()))));
    return jacobian_at_time(jacobians_, side_.column(m), size);
  }
  [[nodiscard]] Vec product(Eigen::Index m, const Rows& y) const {
    const Vec all = jacobian(m) * y.col(side_.column(m));
    return all(side_.rows_);
  }
  // dg_i/dy_j at an own time, and at the points of a panel.
  [[nodiscard]] double slope(Eigen::Index m, Eigen::Index i, Eigen::Index j) const {
    return jacobian(m)(side_.rows_[static_cast<std::size_t>(i)], side_.rows_[static_cast<std::size_t>(j)]);
  }
  [[nodiscard]] Vec slopes(Eigen::Index panel, Eigen::Index i, Eigen::Index j) const {
    const auto n = side_.points();
    return Vec::NullaryExpr(n, [&](Eigen::Index p) { return slope(panel * n + p + 1, i, j); });
  }

  const PanelSide& side_;
  const Matrix& jacobians_;
  std::vector<Eigen::PartialPivLU<Matrix>> factors_{};
  Eigen::PartialPivLU<Matrix> at_end_{};
};

PanelSide::PanelSide(const Problem& problem, Side side, const PanelMesh& mesh, const LegendrePoints& points)
    : SideRule(problem, side),
      lengths_(side == Side::right ? mesh.mirrored().lengths : mesh.lengths),
      points_(points),
      last_(std::ssize(lengths_) * points.points.size() + 1) {
  for (Eigen::Index i = 0; i < differential_count_; ++i) {
    const double order = problem.component(rows_[static_cast<std::size_t>(i)]).order;
    auto found = std::ranges::find(integrals_, order, &Integrals::order);
    if (found == integrals_.end())
      found = integrals_.insert(found, Integrals{.order = order, .rows = {}, .weights = weights(order)});
    found->rows.push_back(i);
  }
}

// Panels whose lengths are powers of 2 times each other recur in a few relative positions.
Matrix PanelSide::weights(double order) const {
  const auto n = points();
  Matrix all = Matrix::Zero(last_, last_ - 1);
  std::map<std::pair<double, double>, Matrix> known;
  for (Eigen::Index j = 0; j < panels(); ++j) {
    const double length = lengths_[static_cast<std::size_t>(j)], unit = std::pow(length / 2.0, order);
    const auto integrals = [&](const Vec& beyond) -> Matrix {
      return kernel_moments(order, beyond, n) * points_.to_coefficients;
    };
    double gap = 0.0;
    all.block(j * n, j * n, n, n) = unit * integrals(points_.points.array() - 1.0);
    for (Eigen::Index k = j + 1; k < panels(); ++k) {
      const double width = lengths_[static_cast<std::size_t>(k)];
      auto& block = known[{width / length, gap / length}];
      if (block.size() == 0) block = integrals((2.0 * gap + width * (1.0 + points_.points.array())) / length);
      all.block(k * n, j * n, n, n) = unit * block;
      gap += width;
    }
    all.block(last_ - 1, j * n, 1, n) = unit * integrals(Vec::Constant(1, 2.0 * gap / length));
  }
  return all;
}

Rows PanelSide::own(const Rows& all) const {
  Rows values(std::ssize(rows_), last_);
  for (Eigen::Index m = 1; m <= last_; ++m) values.col(m - 1) = all.col(column(m))(rows_);
  return values;
}

void PanelSide::integrate(const Rows& f, Rows& value) const {
  if (empty()) return;
  const Rows own_f = own(f);
  Rows sums = own_f;  // of algebraic rows
  for (const auto& [order, rows, weights] : integrals_) {
    const Rows of_order = own_f(rows, Eigen::seqN(0, last_ - 1));
    sums(rows, Eigen::all) = of_order * weights.transpose();
  }
  for (Eigen::Index m = 1; m <= last_; ++m) {
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      const auto row = static_cast<Eigen::Index>(i);
      double& entry = value(rows_[i], column(m));
      entry = sums(row, m - 1) + (row < differential_count_ ? entry : 0.0);
    }
  }
}

std::unique_ptr<SideFactors> PanelSide::factors(const Matrix& jacobians) const {
  return std::make_unique<Factors>(*this, jacobians);
}

std::size_t PanelSide::bytes() const {
  return sizeof(double) * integrals_.size() * static_cast<std::size_t>(last_ * (last_ - 1));
}

void PanelSide::add_integrals(const Rows& f, Eigen::Index panel, double since, Out y) const {
  if (empty()) return;
  const auto n = points();
  const Rows own_f = own(f);
  for (const auto& [order, rows, weights] : integrals_) {
    double gap = since * lengths_[static_cast<std::size_t>(panel)];  // from the end of panel j to the time
    for (Eigen::Index j = panel; j >= 0; --j) {
      const double length = lengths_[static_cast<std::size_t>(j)], unit = std::pow(length / 2.0, order);
      const Vec moments = j == panel
                              ? moments_inside_panel(order, 2.0 * since, n)
                              : Vec(kernel_moments(order, Vec::Constant(1, 2.0 * gap / length), n).row(0));
      const Vec of_values = unit * (points_.to_coefficients.transpose() * moments);
      for (const auto i : rows)
        y[rows_[static_cast<std::size_t>(i)]] += own_f.row(i).segment(j * n, n).dot(of_values);
      if (j < panel) gap += length;
    }
  }
}

std::shared_ptr<const Discretisation> discretisation_by_panels(const Problem& problem, const PanelMesh& mesh,
                                                               const LegendrePoints& points,
                                                               std::shared_ptr<const PanelSide> left,
                                                               std::shared_ptr<const PanelSide> right) {
  const auto n = points.points.size(), last = static_cast<Eigen::Index>(mesh.size()) * n + 1;
  const auto times = [&](const PanelMesh& of) {
    Vec all = Vec::Zero(last + 1);
    const Vec edges = of.edges();
    for (std::size_t k = 0; k < of.size(); ++k) {
      const auto panel = static_cast<Eigen::Index>(k);
      all.segment(panel * n + 1, n) = edges[panel] + of.lengths[k] * (1.0 + points.points.array()) / 2.0;
    }
    all[last] = problem.end;
    return all;
  };
  return std::make_shared<const Discretisation>(
      Discretisation{.left = times(mesh),
                     .right = times(mesh.mirrored()).reverse(),
                     .left_rule = std::move(left),
                     .right_rule = std::move(right),
                     .with_steps = [&problem](int steps) {
                       return discretisation_by_steps(problem, {problem.end, steps}, {}, families::trapezoid);
                     }});
}

}  // namespace fde
