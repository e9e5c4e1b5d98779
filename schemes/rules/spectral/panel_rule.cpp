// SPDX-License-Identifier: MIT
#include "fdebench/schemes/rules/spectral/panel_rule.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <mutex>
#include <numbers>
#include <utility>

#include "fdebench/schemes/history/weights/kernel_moments.hpp"
#include "fdebench/schemes/problem/chain.hpp"
#include "fdebench/schemes/problem/smoothness.hpp"
#include "fdebench/schemes/stepping/setup_time.hpp"

namespace fde {

namespace {

// The points and the coefficients of polynomials are computed with more digits.
using Real = long double;
using WideVec = Eigen::Vector<Real, Eigen::Dynamic>;

template <class Points>
auto legendre(const Points& points, Eigen::Index count) {
  using Number = typename Points::Scalar;
  Eigen::Matrix<Number, Eigen::Dynamic, Eigen::Dynamic> p(points.size(), count);
  p.col(0).setOnes();
  if (count > 1) p.col(1) = points;
  for (Eigen::Index l = 1; l + 1 < count; ++l) {
    const auto degree = static_cast<Number>(l);
    p.col(l + 1) = (2 * degree + 1) / (degree + 1) * points.cwiseProduct(p.col(l)) -
                   degree / (degree + 1) * p.col(l - 1);
  }
  return p;
}

// A step of Newton's method to the zeros of P_n - P_(n-1), whose slope is n (P_n + P_(n-1)) / (1 + x).
template <class Points>
void improve_radau_points(Points& x) {
  const auto count = x.size();
  const auto p = legendre(x, count + 1);
  const auto highest = p.col(count).array(), lower = p.col(count - 1).array();
  x.array() -=
      (1 + x.array()) * (highest - lower) / (static_cast<typename Points::Scalar>(count) * (highest + lower));
}

// Increasing. They are near the cosines of (k + 1/4) pi / n, but for the last, which is 1.
WideVec radau_points(Eigen::Index count) {
  constexpr int steps = 4;  // to rounding; each squares the error
  Vec rounded = Vec::NullaryExpr(count, [&](Eigen::Index i) {
    const auto from_end = static_cast<double>(count - 1 - i);
    return from_end == 0.0 ? 1.0
                           : std::cos((from_end + 0.25) * std::numbers::pi / static_cast<double>(count));
  });
  for (int step = 0; step < steps; ++step) improve_radau_points(rounded);
  WideVec points = rounded.cast<Real>();
  improve_radau_points(points);
  return points;
}

// The values at other places of the polynomial through values at the points, one row a place: in barycentric
// form, to rounding (Berrut & Trefethen, SIAM Rev. 46 (2004)).
Matrix interpolation(const Vec& points, const Vec& factors, const Vec& places) {
  Matrix rows(places.size(), points.size());
  for (Eigen::Index i = 0; i < points.size(); ++i) rows.col(i) = factors[i] / (places.array() - points[i]);
  const Vec sums = rows.rowwise().sum();
  for (Eigen::Index i = 0; i < points.size(); ++i)
    rows.col(i) = (places.array() == points[i]).select(1.0, rows.col(i).cwiseQuotient(sums));
  return rows;
}

// The P_l((y - 1) / 2), one column each, as sums of the P_m(y): the recurrence in l, with that in m for
// products with y.
Matrix on_older_half(Eigen::Index count) {
  const Eigen::ArrayXd degrees = Eigen::ArrayXd::LinSpaced(count, 0.0, static_cast<double>(count - 1));
  const Vec raised = ((degrees + 1.0) / (2.0 * degrees + 1.0)).head(count - 1);  // y P_m in P_(m+1)
  const Vec lowered = (degrees / (2.0 * degrees + 1.0)).tail(count - 1);         // and in P_(m-1)
  Matrix columns = Matrix::Identity(count, count);
  for (Eigen::Index l = 0; l + 1 < count; ++l) {
    auto next = columns.col(l + 1);
    next = -columns.col(l);
    next.tail(count - 1) += raised.cwiseProduct(columns.col(l).head(count - 1));
    next.head(count - 1) += lowered.cwiseProduct(columns.col(l).tail(count - 1));
    next *= (degrees[l] + 0.5) / (degrees[l] + 1.0);
    if (l > 0) next -= degrees[l] / (degrees[l] + 1.0) * columns.col(l - 1);
  }
  return columns;
}

// D^node of sum_k initial[k] t^k / k!.
std::vector<IntegratedRow::Power> derivative_of_start(const std::vector<double>& initial, double node) {
  std::vector<IntegratedRow::Power> start;
  for (std::size_t k = 0; k < initial.size(); ++k) {
    const double power = static_cast<double>(k) - node;
    if (power >= 0.0 && initial[k] != 0.0) start.push_back({initial[k] / std::tgamma(power + 1.0), power});
  }
  return start;
}

}  // namespace

Matrix legendre_polynomials(const Vec& points, Eigen::Index count) { return legendre(points, count); }

PanelRule::PanelRule(Eigen::Index count) {
  const WideVec x = radau_points(count), one_plus = 1 + x.array();
  points = x.cast<double>();
  const auto p = legendre(x, count);
  const WideVec highest = static_cast<Real>(count) * p.col(count - 1);
  // Radau quadrature is exact for products of the polynomials, so they are orthogonal at the points.
  const WideVec weights = one_plus.array() / highest.array().square();
  const WideVec norms = WideVec::LinSpaced(count, 0.5L, static_cast<Real>(count) - 0.5L);  // 1 / int P_l^2
  to_coefficients = (norms.asDiagonal() * p.transpose() * weights.asDiagonal()).template cast<double>();
  at_start = ((count % 2 == 0 ? -1 : 1) / highest.array()).cast<double>();
  const Vec factors = one_plus.cwiseQuotient(highest).cast<double>();
  to_older_half = interpolation(points, factors, (points.array() - 1.0) / 2.0);
  to_newer_half = interpolation(points, factors, (points.array() + 1.0) / 2.0);
  const Vec per_norm = norms.cwiseInverse().cast<double>() / 2.0;
  from_older = norms.cast<double>().asDiagonal() * on_older_half(count).transpose() * per_norm.asDiagonal();
  const Vec signs = Vec::NullaryExpr(count, [](Eigen::Index l) { return l % 2 == 0 ? 1.0 : -1.0; });
  from_newer = signs.asDiagonal() * from_older * signs.asDiagonal();
}

const PanelRule& panel_rule(Eigen::Index points) {
  struct Retained {
    PanelRule rule;
    double seconds;
  };
  static std::mutex mutex;
  static std::map<Eigen::Index, Retained> made;
  const std::scoped_lock lock(mutex);
  auto found = made.find(points);
  if (found == made.end()) {
    const double start = thread_seconds();
    PanelRule rule(points);
    found = made.emplace(points, Retained{std::move(rule), thread_seconds() - start}).first;
  }
  count_table(&found->second, found->second.seconds);
  return found->second.rule;
}

PanelKernels::PanelKernels(const PanelRule& rule, const IntegratedRows& integrated_rows) : rule_(rule) {
  for (const auto& row : integrated_rows.rows) {
    if (row.order == 0.0) {
      order_of_.push_back(-1);
      continue;
    }
    const auto found = std::ranges::find(orders_, row.order);
    order_of_.push_back(found - orders_.begin());
    if (found == orders_.end()) orders_.push_back(row.order);
  }
  const Vec beyond = rule.points.array() - 1.0;
  for (const double order : orders_)
    own_integrals_.emplace_back(kernel_moments(order, beyond, rule.size()) * rule.to_coefficients);
}

Vec PanelKernels::units(double width) const {
  Vec units(std::ssize(orders_));
  for (Eigen::Index g = 0; g < units.size(); ++g)
    units[g] = std::pow(width / 2.0, orders_[static_cast<std::size_t>(g)]);
  return units;
}

const std::vector<Matrix>& PanelKernels::integrals_on(const RelativePosition& position) {
  auto found = cache_.find(position);
  if (found == cache_.end()) found = cache_.emplace(position, compute_integrals(position)).first;
  return found->second;
}

std::vector<Matrix> PanelKernels::compute_integrals(const RelativePosition& position) const {
  const Vec beyond = (2.0 * position.gap + 1.0 + rule_.points.array()) / position.width;
  std::vector<Matrix> kernels;
  for (const double order : orders_) kernels.push_back(kernel_moments(order, beyond, rule_.size()));
  return kernels;
}

std::size_t PanelKernels::bytes() const {
  return sizeof(double) * (cache_.size() + 1) * orders_.size() *
         static_cast<std::size_t>(rule_.size() * rule_.size());
}

IntegratedRows::IntegratedRows(const Problem& problem)
    : rows(problem.components.size()), origin(Vec::Zero(problem.size())) {
  std::vector<bool> chained(rows.size(), false);
  for (const auto& equation : problem.equations) {
    const Chain chain = chain_of(problem, equation);
    for (Eigen::Index i = 0; i < chain.size(); ++i) {
      const auto row = static_cast<std::size_t>(chain.first_row() + i);
      const double node = chain.nodes()[static_cast<std::size_t>(i)];
      rows[row] = {unknown_count(), chain.leading().order - node, derivative_of_start(chain.initial(), node)};
      chained[row] = true;
    }
    rhs_indices.push_back(chain.first_row() + chain.size() - 1);
  }
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (chained[i]) continue;
    const auto& component = problem.components[i];
    rows[i] = {unknown_count(), component.order, {}};
    if (!is_algebraic(component)) rows[i].taylor_terms = derivative_of_start(component.initial, 0.0);
    rhs_indices.push_back(static_cast<Eigen::Index>(i));
  }
  if (!problem.increments.is_given()) return;
  origin = problem.increments.origin;
  for (auto& row : rows) std::erase_if(row.taylor_terms, [](const auto& term) { return term.power == 0.0; });
}

bool IntegratedRows::have_one_order() const {
  for (Eigen::Index i = 0; i < row_count(); ++i) {
    const auto& row = rows[static_cast<std::size_t>(i)];
    if (row.is_algebraic() || row.order != rows.front().order || row.unknown != i ||
        rhs_indices[static_cast<std::size_t>(i)] != i)
      return false;
  }
  return true;
}

Vec IntegratedRows::taylor_part(double t) const {
  Vec value = Vec::Zero(row_count());
  for (Eigen::Index i = 0; i < row_count(); ++i) {
    for (const auto& [coefficient, power] : rows[static_cast<std::size_t>(i)].taylor_terms)
      value[i] += coefficient * (power == 0.0 ? 1.0 : power == 1.0 ? t : std::pow(t, power));
  }
  return value;
}

}  // namespace fde
