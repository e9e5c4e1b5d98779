// SPDX-License-Identifier: MIT
#include "fdebench/reference/two_sided/sinc_nodes.hpp"

#include <cmath>
#include <limits>
#include <numbers>

namespace fde::reference {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double last = 5.5;              // t^0.1 is 1e-16 there
constexpr double quadrature_step = 0.02;  // resolves f next to the end of the interval

RelativeTime mapped(double x) {
  const double exponent = pi * std::sinh(x);
  return {1.0 / (1.0 + std::exp(-exponent)), 1.0 / (1.0 + std::exp(exponent))};
}

// sin(pi x) / (pi x) for x = place - j, j = -count ... count.
Vec sinc(double place, Eigen::Index count) {
  Vec values(2 * count + 1);
  const double nearest = std::round(place), rest = place - nearest, sine = std::sin(pi * rest);
  for (Eigen::Index j = -count; j <= count; ++j) {
    const double x = place - static_cast<double>(j);
    const double sign = std::fmod(std::abs(nearest - static_cast<double>(j)), 2.0) == 0.0 ? 1.0 : -1.0;
    values[j + count] = x == 0.0 ? 1.0 : sign * sine / (pi * x);
  }
  return values;
}

class SincNodes {
 public:
  explicit SincNodes(double step) : step_(step), count_(static_cast<Eigen::Index>(last / step)) {
    nodes_.push_back({0.0, 1.0});
    for (Eigen::Index j = -count_; j <= count_; ++j) nodes_.push_back(mapped(static_cast<double>(j) * step_));
    nodes_.push_back({1.0, 0.0});
  }

  [[nodiscard]] const std::vector<RelativeTime>& nodes() const { return nodes_; }

  // With s = t u: t^order / Gamma(order) int_0^1 (1-u)^(order-1) f(t u) du. Beyond the last point u is 1 up
  // to rounding; for small orders that part of int (1-u)^(order-1) du = 1 / order is not negligible, and
  // takes f(t).
  [[nodiscard]] Vec row(double order, RelativeTime t) const {
    Vec row = Vec::Zero(std::ssize(nodes_));
    if (t.from_start == 0.0) return row;
    const auto points = static_cast<int>(last / quadrature_step);
    double beyond = 1.0 / order;
    for (int k = -points; k <= points; ++k) {
      const double x = k * quadrature_step;
      const RelativeTime u = mapped(x);
      const double weight = quadrature_step * pi * std::cosh(x) * u.from_start * std::pow(u.from_end, order);
      add_interpolated({t.from_start * u.from_start, t.from_end + t.from_start * u.from_end}, weight, row);
      beyond -= weight;
    }
    add_interpolated(t, beyond, row);
    row *= std::pow(t.from_start, order) / std::tgamma(order);
    return row;
  }

 private:
  void add_interpolated(RelativeTime t, double weight, Vec& row) const {
    if (t.from_start < std::numeric_limits<double>::min()) {
      row[0] += weight;
      return;
    }
    if (t.from_end < std::numeric_limits<double>::min()) {
      row[row.size() - 1] += weight;
      return;
    }
    const double x = std::asinh(std::log(t.from_start / t.from_end) / pi);
    const Vec shares = weight * sinc(x / step_, count_);
    double at_start = weight * t.from_end, at_end = weight * t.from_start;
    for (Eigen::Index j = 0; j < shares.size(); ++j) {
      const RelativeTime& node = nodes_[static_cast<std::size_t>(j) + 1];
      at_start -= shares[j] * node.from_end;
      at_end -= shares[j] * node.from_start;
    }
    row.segment(1, shares.size()) += shares;
    row[0] += at_start;
    row[row.size() - 1] += at_end;
  }

  double step_;
  Eigen::Index count_;
  std::vector<RelativeTime> nodes_;
};

}  // namespace

NodalBasis sinc_nodes(double step) {
  const SincNodes basis(step);
  return {basis.nodes(), [basis](double order) -> NodalBasis::Row {
            return [basis, order](RelativeTime t) { return basis.row(order, t); };
          }};
}

}  // namespace fde::reference
