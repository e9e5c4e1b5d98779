#include "problem/chain.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace fde {
Chain::Chain(Term leading, const std::vector<Term>& terms, std::vector<double> initial)
    : leading_(leading), initial_(std::move(initial)) {
  if (leading_.coefficient == 0.0)
    throw std::invalid_argument("the coefficient of the leading derivative is 0");
  for (int whole = 0; whole < leading_.order; ++whole) nodes_.push_back(whole);
  for (const auto& [coefficient, order] : terms) {
    if (!(order >= 0.0 && order < leading_.order)) {
      throw std::invalid_argument(fmt::format("order {} of a term is not in [0, {})", order, leading_.order));
    }
    if (coefficient != 0.0 && !node(order)) nodes_.push_back(order);
  }
  std::ranges::sort(nodes_);
  coefficients_.setZero(size());
  for (const auto& [coefficient, order] : terms) {
    if (coefficient != 0.0) coefficients_[*node(order)] += coefficient;
  }
}

std::vector<Component> Chain::components() const {
  std::vector<Component> components;
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    const double next = i + 1 < nodes_.size() ? nodes_[i + 1] : leading_.order;
    const double start =
        std::floor(nodes_[i]) == nodes_[i] ? initial_[static_cast<std::size_t>(std::lround(nodes_[i]))] : 0.0;
    components.push_back({next - nodes_[i], {start}});
  }
  return components;
}

std::optional<Eigen::Index> Chain::node(double order) const {
  const auto found = std::ranges::find(nodes_, order);
  if (found == nodes_.end()) return std::nullopt;
  return found - nodes_.begin();
}

double Chain::terms(In y) const { return coefficients_.dot(y); }

double Chain::highest(In y, double force, double factor) const {
  return (force - factor * terms(y)) / leading_.coefficient;
}

void Chain::links(In y, double highest, Out f) {
  f.head(f.size() - 1) = y.tail(y.size() - 1);
  f[f.size() - 1] = highest;
}

Matrix Chain::linear_part(double stiffness) const {
  Matrix jacobian = Matrix::Zero(size(), size());
  jacobian.diagonal(1).setOnes();
  Vec gradient(size());
  highest_gradient(stiffness, 1.0, gradient);
  jacobian.row(size() - 1) = gradient.transpose();
  return jacobian;
}

void Chain::highest_gradient(double force_by_u, double factor, Out gradient) const {
  gradient = -factor * coefficients_;
  gradient[0] += force_by_u;
  gradient /= leading_.coefficient;
}

Smoothness chain_smoothness(const std::vector<Chain>& chains) {
  const double leading = chains.front().leading_.order;
  std::vector<double> orders, start{leading};
  for (const auto& chain : chains) {
    for (std::size_t i = 0; i < chain.nodes_.size(); ++i) {
      if (i == 0 || chain.coefficients_[static_cast<Eigen::Index>(i)] != 0.0)
        orders.push_back(chain.nodes_[i]);
    }
    for (std::size_t k = 1; k < chain.initial_.size(); ++k) {
      if (chain.initial_[k] != 0.0) start.push_back(static_cast<double>(k));
    }
  }

  // A power p of u drives D^leading u with p - order for every term (order 0: the force), so u has p - order
  // + leading.
  const auto powers = power_closure(start, leading + 2.0, [&](double p) {
    std::vector<double> following;
    for (const double order : orders) {
      const bool annihilated = whole(p) && p < std::ceil(order);
      if (!annihilated) following.push_back(p - order + leading);
    }
    return following;
  });

  Smoothness smoothness;
  for (const auto& chain : chains) {
    for (const double node : chain.nodes_) {
      auto& of_node = smoothness.powers.emplace_back();
      for (const double p : powers) {
        if (p > node && !same_order(p, node)) of_node.push_back(p - node);
      }
    }
  }
  return smoothness;
}

}  // namespace fde
