// SPDX-License-Identifier: MIT
#include "fdebench/reference/two_sided/nodal_basis.hpp"

#include <cmath>
#include <limits>
#include <memory>
#include <numbers>

namespace fde::reference {

namespace {

constexpr double pi = std::numbers::pi;
constexpr double last_node = 5.5;         // t^0.1 is 1e-16 there
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
  explicit SincNodes(double step) : step_(step), count_(static_cast<Eigen::Index>(last_node / step)) {
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
    const auto points = static_cast<int>(last_node / quadrature_step);
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

constexpr int quadrature_points = 24;
constexpr double same_place = 1e-12;  // points closer in x than this are the same

// after - before without cancellation. Precondition: before <= after.
double distance(RelativeTime before, RelativeTime after) {
  return after.from_start < 0.5 ? after.from_start - before.from_start : before.from_end - after.from_end;
}

RelativeTime share(double x) { return {x, 1.0 - x}; }

// Nodes and weights on [0, 1] in double, for the weight (1-u)^power. For a target at the end of the interval
// the kernel has another exponent than for a target inside.
struct Rule {
  explicit Rule(double of_end)
      : Rule(of_end, gauss_jacobi(quadrature_points, static_cast<long double>(of_end))) {}
  Rule(double of_end, const GaussRule& rule)
      : power(of_end), nodes(rule.nodes.cast<double>()), weights(rule.weights.cast<double>()) {}
  double power;
  Vec nodes, weights;
};

class ClusteredPanels {
 public:
  ClusteredPanels(const PanelBasis& panel, int panels, const ClusteringMap& time)
      : time_(time),
        inner_(panel.nodes),
        barycentric_(barycentric_weights(panel.gauss.nodes).cast<double>()),
        panels_(panels) {
    const auto points = inner_.size(), all = points * panels;
    Vec x(all);
    for (Eigen::Index k = 0; k < panels; ++k)
      x.segment(k * points, points) = (inner_.array() + static_cast<double>(k)) / panels;
    nodes_.push_back({0.0, 1.0});
    for (Eigen::Index m = 0; m < all; ++m) nodes_.push_back(time_.at({x[m], x[all - 1 - m]}));
    nodes_.push_back({1.0, 0.0});
  }

  [[nodiscard]] const std::vector<RelativeTime>& nodes() const { return nodes_; }

  [[nodiscard]] Vec row(double order, const Rule& singular, RelativeTime t) const {
    Vec row = Vec::Zero(std::ssize(nodes_));
    const double x = time_.inverse(t).from_start;
    for (int k = 0; k < panels_; ++k) {
      const double from = static_cast<double>(k) / panels_, to = (k + 1.0) / panels_;
      if (from >= x - same_place) break;
      add(order, t, x, k, from, to < x - same_place ? to : x, singular, row);
    }
    row /= std::tgamma(order);
    return row;
  }

 private:
  // Adds the integral over the part [from, to] of a panel. A part that ends at the target takes the singular
  // rule; a part closer to the target than its length is bisected.
  void add(double order, RelativeTime t, double x, int panel, double from, double to, const Rule& singular,
           Vec& row) const {
    const double length = to - from, gap = x - to;
    if (gap > 0.0 && gap < length) {
      const double middle = from + length / 2;
      add(order, t, x, panel, from, middle, singular, row);
      add(order, t, x, panel, middle, to, singular, row);
      return;
    }
    const Rule& rule = gap > 0.0 ? regular_ : singular;
    for (Eigen::Index q = 0; q < rule.nodes.size(); ++q) {
      const RelativeTime y = share(from + length * rule.nodes[q]);
      const double kernel =
          std::pow(distance(time_.at(y), t), order - 1.0) / std::pow(1.0 - rule.nodes[q], rule.power);
      const double weight = length * rule.weights[q] * kernel * time_.derivative(y);
      add_interpolated(panel, y.from_start * panels_ - panel, weight, row);
    }
  }

  void add_interpolated(int panel, double inside, double weight, Vec& row) const {
    const auto first = 1 + panel * inner_.size();
    const Vec shares = barycentric_.array() / (inside - inner_.array());
    if (shares.allFinite()) {
      row.segment(first, inner_.size()) += (weight / shares.sum()) * shares;
    } else {
      Eigen::Index hit = 0;
      (inner_.array() - inside).abs().minCoeff(&hit);
      row[first + hit] += weight;
    }
  }

  ClusteringMap time_;
  Vec inner_, barycentric_;
  int panels_;
  std::vector<RelativeTime> nodes_;
  Rule regular_{0.0};
};

}  // namespace

NodalBasis sinc_nodes(double step) {
  const SincNodes basis(step);
  return {basis.nodes(), [basis](double order) -> NodalBasis::Row {
            return [basis, order](RelativeTime t) { return basis.row(order, t); };
          }};
}

double ClusteringMap::cubic(double x) const {
  return x * (6.0 * bend_ + 2.0 / power_ - 12.0 * bend_ * x + 8.0 * bend_ * x * x);
}
double ClusteringMap::slope(double x) const {
  return 6.0 * bend_ + 2.0 / power_ - 24.0 * bend_ * x * (1.0 - x);
}

double ClusteringMap::derivative(RelativeTime x) const {
  const RelativeTime t = at(x);
  return power_ * t.from_start * t.from_end * slope(x.from_start) / (cubic(x.from_start) * cubic(x.from_end));
}

RelativeTime ClusteringMap::at(RelativeTime x) const {
  const double start = std::pow(cubic(x.from_start), power_), end = std::pow(cubic(x.from_end), power_);
  return {start / (start + end), end / (start + end)};
}

// Newton's method for the share of the nearer end, where v is convex.
RelativeTime ClusteringMap::inverse(RelativeTime t) const {
  const double start = std::pow(t.from_start, 1.0 / power_), end = std::pow(t.from_end, 1.0 / power_);
  const double nearer = std::min(start, end) / (start + end);
  double x = nearer / slope(0.0);
  for (int i = 0; i < 60; ++i) {
    const double step = (nearer - cubic(x)) / slope(x);
    x = std::min(x + step, 0.5);
    if (std::abs(step) <= 0x1p-52 * x) break;
  }
  return start <= end ? RelativeTime{x, 1.0 - x} : RelativeTime{1.0 - x, x};
}

NodalBasis clustered_panels(const PanelBasis& panel, int panels, const ClusteringMap& time) {
  const auto basis = std::make_shared<const ClusteredPanels>(panel, panels, time);
  return {basis->nodes(), [basis, power = time.power()](double order) -> NodalBasis::Row {
            return [basis, order, inside = Rule(order - 1.0), at_end = Rule(power * order - 1.0)](
                       RelativeTime t) { return basis->row(order, t.from_end == 0.0 ? at_end : inside, t); };
          }};
}

}  // namespace fde::reference
