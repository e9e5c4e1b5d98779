// SPDX-License-Identifier: MIT
#include "fdebench/schemes/problem/chain.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <stdexcept>
#include <utility>

#include "fdebench/schemes/problem/vectors.hpp"

namespace fde {

namespace {

using Equations = std::vector<MultiTermEquation>;

Equations with_factors(Equations equations) {
  for (auto& equation : equations) {
    if (!equation.factor) equation.factor = [](double, In) { return 1.0; };
  }
  return equations;
}

// sum_k c_k D^(a_k) u.
double sum_of_terms(const Chain& chain, In y) {
  const Vec& coefficients = chain.coefficients();
  double sum = 0.0;
  for_each_component(coefficients.size(),
                     [&](Eigen::Index i) { sum += coefficients[i] * y[chain.first_row() + i]; });
  return sum;
}

// f_i = y_{i+1}; the last f of each chain is D^leading u. An empty factor is 1.
void evaluate(const std::vector<MultiTermEquation>& equations, double t, In y, Out f) {
  for (const auto& [chain, force, factor, _] : equations) {
    const auto first = chain.first_row(), last = first + chain.size() - 1;
    for_each_component(chain.size() - 1, [&](Eigen::Index i) { f[first + i] = y[first + i + 1]; });
    double leading_term = force(t, y);
    const double scale = factor ? factor(t, y) : 1.0, leading = chain.leading().coefficient;
    leading_term -= scale * sum_of_terms(chain, y);
    f[last] = leading == 1.0 ? leading_term : leading_term / leading;
  }
}

void add_gradient(const NoDerivatives& /*none*/, const Chain& /*chain*/, double /*t*/, In /*y*/,
                  Out /*gradient*/) {}
void add_gradient(const LinearForce& force, const Chain& chain, double /*t*/, In /*y*/, Out gradient) {
  gradient[chain.first_row()] += force.by_u;
}
void add_gradient(const ForceGradient& force, const Chain& chain, double t, In y, Out gradient) {
  force.add(t, y, sum_of_terms(chain, y), gradient);
}

void differentiate(const Equations& equations, double t, In y, OutMatrix jacobian) {
  jacobian.setZero();
  jacobian.diagonal(1).setOnes();
  Vec gradient(y.size());
  for (const auto& equation : equations) {
    const auto& chain = equation.chain;
    gradient.setZero();
    gradient.segment(chain.first_row(), chain.size()) = -equation.factor(t, y) * chain.coefficients();
    std::visit([&](const auto& force) { add_gradient(force, chain, t, y, gradient); }, equation.derivatives);
    gradient /= chain.leading().coefficient;
    jacobian.row(chain.first_row() + chain.size() - 1) = gradient.transpose();
  }
}

template <class Kind>
bool tells(const MultiTermEquation& equation) {
  return std::holds_alternative<Kind>(equation.derivatives);
}

Derivatives derivatives_of(const Equations& equations, Eigen::Index size) {
  if (std::ranges::all_of(equations, tells<LinearForce>)) {
    DenseLinearPart linear{Matrix(size, size)};
    differentiate(equations, 0.0, Vec::Zero(size), linear.matrix);
    return linear;
  }
  if (std::ranges::any_of(equations, tells<NoDerivatives>)) return NoDerivatives{};
  return DenseJacobian{
      [equations](double t, In y, OutMatrix jacobian) { differentiate(equations, t, y, jacobian); }};
}

}  // namespace

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
    components.push_back({next - nodes_[i], {0.0}});
    if (std::floor(nodes_[i]) != nodes_[i]) continue;
    const auto whole = static_cast<std::size_t>(std::lround(nodes_[i]));
    components.back().initial =
        whole < initial_.size() ? std::vector{initial_[whole]} : std::vector<double>{};
  }
  return components;
}

Chain Chain::with_some_initial_values() const {
  Chain chain = *this;
  chain.initial_.resize(initial_count(leading_.order), 1.0);
  return chain;
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

Problem chain_problem(const std::vector<MultiTermEquation>& equations, double end) {
  const Equations scaled = with_factors(equations);
  Problem problem{.rhs = [equations](double t, In y, Out f) { evaluate(equations, t, y, f); }, .end = end};
  for (const auto& [chain, force, factor, _] : scaled) {
    if (chain.first_row() != problem.size())
      throw std::invalid_argument("a chain does not begin where the one before it ends");
    std::ranges::copy(chain.components(), std::back_inserter(problem.components));
    problem.equations.push_back({chain.first_row(), chain.leading(), chain.terms(), force, factor});
  }
  problem.derivatives = derivatives_of(scaled, problem.size());
  return problem;
}

Chain chain_of(const Problem& problem, const Equation& equation) {
  const auto& [first, leading, terms, force, factor, text] = equation;
  std::vector<double> initial(initial_count(leading.order), 0.0);
  const Chain nodes(leading, terms, initial, first);
  for (std::size_t k = 0; k < initial.size(); ++k) {
    const auto row = static_cast<std::size_t>(*nodes.row(static_cast<double>(k)));
    initial[k] = problem.components[row].initial.front();
  }
  return {leading, terms, initial, first};
}

}  // namespace fde
