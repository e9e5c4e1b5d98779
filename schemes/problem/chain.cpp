// SPDX-License-Identifier: MIT
#include "fdebench/schemes/problem/chain.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace fde {

Chain::Chain(Term leading, const std::vector<Term>& terms, std::vector<double> initial,
             Eigen::Index first_row)
    : leading_(leading), initial_(std::move(initial)), first_row_(first_row) {
  if (leading_.coefficient == 0.0)
    throw std::invalid_argument("the coefficient of the leading derivative is 0");
  for (int whole = 0; whole < leading_.order; ++whole) nodes_.push_back(whole);
  for (const auto& [coefficient, order] : terms) {
    if (!(order >= 0.0 && order < leading_.order)) {
      throw std::invalid_argument(fmt::format("order {} of a term is not in [0, {})", order, leading_.order));
    }
    if (coefficient != 0.0 && !row(order)) nodes_.push_back(order);
  }
  std::ranges::sort(nodes_);
  coefficients_.setZero(size());
  for (const auto& [coefficient, order] : terms) {
    if (coefficient != 0.0) coefficients_[*row(order) - first_row_] += coefficient;
  }
}

Chain Chain::single_row(Term leading, std::vector<double> initial, Eigen::Index first_row) {
  Chain chain(leading, {}, std::move(initial), first_row);
  chain.nodes_ = {0.0};
  chain.coefficients_.setZero(1);
  return chain;
}

std::vector<Term> Chain::terms() const {
  std::vector<Term> terms;
  for (Eigen::Index i = 0; i < size(); ++i) {
    if (coefficients_[i] != 0.0) terms.push_back({coefficients_[i], nodes_[static_cast<std::size_t>(i)]});
  }
  return terms;
}

std::optional<Eigen::Index> Chain::row(double order) const {
  const auto found = std::ranges::find(nodes_, order);
  if (found == nodes_.end()) return std::nullopt;
  return first_row_ + (found - nodes_.begin());
}

std::vector<Component> Chain::components() const {
  if (size() == 1) return {{leading_.order, initial_}};
  std::vector<Component> components;
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    const double next = i + 1 < nodes_.size() ? nodes_[i + 1] : leading_.order;
    const double start =
        std::floor(nodes_[i]) == nodes_[i] ? initial_[static_cast<std::size_t>(std::lround(nodes_[i]))] : 0.0;
    components.push_back({next - nodes_[i], {start}});
  }
  return components;
}

Smoothness smoothness_of_chains(const std::vector<Chain>& chains) {
  const double leading = chains.front().leading().order;
  std::vector<double> orders, start{leading};
  for (const auto& chain : chains) {
    orders.push_back(0.0);
    for (const auto& term : chain.terms()) orders.push_back(term.order);
    for (std::size_t k = 1; k < chain.initial().size(); ++k) {
      if (chain.initial()[k] != 0.0) start.push_back(static_cast<double>(k));
    }
  }

  // A term of order a maps t^p in u to t^(p - a) in D^leading u, hence to t^(p - a + leading) in u; order 0
  // is the force.
  const auto powers = power_closure(start, leading + 2.0, [&](double p) {
    std::vector<double> following;
    for (const double order : orders) {
      const bool annihilated = is_integer_order(p) && p < std::ceil(order);
      if (!annihilated) following.push_back(p - order + leading);
    }
    return following;
  });

  Smoothness smoothness;
  for (const auto& chain : chains) {
    for (const double node : chain.nodes()) {
      auto& of_node = smoothness.powers.emplace_back();
      for (const double p : powers) {
        if (p > node && !same_order(p, node)) of_node.push_back(p - node);
      }
    }
  }
  return smoothness;
}

}  // namespace fde
