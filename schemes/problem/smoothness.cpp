// SPDX-License-Identifier: MIT
#include "fdebench/schemes/problem/smoothness.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>

namespace fde {

namespace {

// The coefficients of t^p / Gamma(p+1) in all components, by p: in this basis an integral of any order only
// shifts p. A sum that is rounding of cancelling terms is taken as 0.
class Series {
 public:
  explicit Series(Eigen::Index size) : size_(size) {}

  void add(double power, Eigen::Index i, double coefficient) {
    if (coefficient == 0.0) return;
    Sum& sum = at(power);
    sum.value[i] += coefficient;
    sum.size[i] += std::abs(coefficient);
  }

  struct Sum {
    Vec value, size;
    [[nodiscard]] Vec cleared() const {
      return (value.array().abs() <= 1e-13 * size.array()).select(0.0, value);
    }
  };
  [[nodiscard]] const std::map<double, Sum>& terms() const { return terms_; }

 private:
  Sum& at(double power) {
    const auto near = terms_.lower_bound(power - 1e-9);
    if (near != terms_.end() && same_order(near->first, power)) return near->second;
    return terms_.emplace(power, Sum{Vec::Zero(size_), Vec::Zero(size_)}).first->second;
  }

  Eigen::Index size_;
  std::map<double, Sum> terms_;
};

// The coefficients of a power, with 0 for components that already have a power within power_separation: the
// powers that follow from it are as close to those that follow from the other one.
Vec distinct(double power, Vec coefficients, const std::vector<std::vector<double>>& powers) {
  for (Eigen::Index i = 0; i < coefficients.size(); ++i) {
    const auto& before = powers[static_cast<std::size_t>(i)];
    if (!before.empty() && power < before.back() + power_separation) coefficients[i] = 0.0;
  }
  return coefficients;
}

}  // namespace

std::vector<double> power_closure(std::vector<double> start, double last,
                                  const std::function<std::vector<double>(double p)>& next) {
  std::set<double> powers;
  std::vector<double> open = std::move(start);
  while (!open.empty()) {
    const double p = open.back();
    open.pop_back();
    const auto near = powers.lower_bound(p - power_separation);
    if (p > last || (near != powers.end() && *near < p + power_separation)) continue;
    powers.insert(p);
    for (const double following : next(p)) open.push_back(following);
  }
  return {powers.begin(), powers.end()};
}

std::vector<double> power_lattice(const std::vector<double>& start, const std::vector<double>& steps,
                                  double last) {
  return power_closure(start, last, [&](double p) {
    std::vector<double> following = steps;
    for (double& step : following) step += p;
    return following;
  });
}

Smoothness linear_smoothness(const std::vector<Component>& components, const Matrix& matrix,
                             const std::vector<PowerLoad>& loads) {
  const Eigen::Index size = matrix.rows();
  Series series(size);
  double last = 2.0;
  for (Eigen::Index i = 0; i < size; ++i) {
    const auto& component = components[static_cast<std::size_t>(i)];
    if (is_algebraic(component)) {
      throw std::invalid_argument("smoothness: component " + std::to_string(i) +
                                  " has order 0, orders have to be above 0");
    }
    if (component.side == Side::right) {
      throw std::invalid_argument("smoothness: component " + std::to_string(i) + " has a right derivative");
    }
    const auto& initial = component.initial;
    last = std::max(last, component.order + 2.0);
    for (std::size_t k = 0; k < initial.size(); ++k) series.add(static_cast<double>(k), i, initial[k]);
  }
  for (const auto& [power, coefficients] : loads) {
    for (Eigen::Index i = 0; i < size; ++i) {
      const double order = components[static_cast<std::size_t>(i)].order;
      series.add(power + order, i, coefficients[i] * std::tgamma(power + 1.0));
    }
  }
  Smoothness smoothness;
  smoothness.powers.resize(components.size());
  // A power only receives contributions from smaller powers, so in increasing order each coefficient is
  // complete when the loop reaches it.
  for (auto term = series.terms().begin(); term != series.terms().end() && term->first <= last; ++term) {
    const double power = term->first;
    const Vec coefficients = distinct(power, term->second.cleared(), smoothness.powers);
    for (Eigen::Index i = 0; i < size; ++i) {
      const auto& order = components[static_cast<std::size_t>(i)].order;
      const bool given = power < order;  // by the initial values
      if (!given && coefficients[i] != 0.0) smoothness.powers[static_cast<std::size_t>(i)].push_back(power);
      for (Eigen::Index j = 0; j < size; ++j) {
        if (coefficients[j] != 0.0) series.add(power + order, i, matrix(i, j) * coefficients[j]);
      }
    }
  }
  return smoothness;
}

}  // namespace fde
