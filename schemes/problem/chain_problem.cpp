// SPDX-License-Identifier: MIT
#include "fdebench/schemes/problem/chain_problem.hpp"

#include <algorithm>
#include <iterator>
#include <stdexcept>

#include "fdebench/schemes/problem/componentwise.hpp"

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
