// SPDX-License-Identifier: MIT
#include "fdebench/schemes/rules/multi_term/multi_term_rates.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <vector>

#include "fdebench/schemes/problem/chain.hpp"
#include "fdebench/schemes/rules/implicit/implicit_rule.hpp"
#include "fdebench/schemes/rules/multi_term/integrated_equations.hpp"
#include "fdebench/schemes/rules/start_weights/multistep_scheme.hpp"

namespace fde {
namespace {

using Powers = std::vector<double>;

const Powers& powers_of(const Smoothness& smoothness, Eigen::Index row) {
  return smoothness.powers[static_cast<std::size_t>(row)];
}

// Precondition: the powers increase. There may be as many as terms times powers of a smooth start.
bool contains(const Powers& powers, double power) {
  const auto next = std::ranges::lower_bound(powers, power);
  return (next != powers.end() && same_order(power, *next)) ||
         (next != powers.begin() && same_order(power, *std::prev(next)));
}

bool listed(const std::vector<Eigen::Index>& rows, Eigen::Index row) {
  return std::ranges::find(rows, row) != rows.end();
}

// The powers of D^v d, given the powers of D^v u: those of T are removed.
Powers without_taylor(Powers powers, const Chain& chain, double node) {
  const double degrees = std::ceil(chain.leading().order);
  std::erase_if(powers,
                [=](double q) { return is_integer_order(q + node) && std::round(q + node) < degrees; });
  return powers;
}

// The rows on which g depends, found by perturbing each at t = 0 and at a later time; all terms where the
// factor is not 1.
std::vector<Eigen::Index> rows_read(const Problem& problem, const Equation& equation, const Chain& chain) {
  std::vector<Eigen::Index> rows;
  const Vec start = taylor_part(problem, 0.0);
  for (const double t : {0.0, problem.end / 3.0}) {
    Vec y = start;
    for (Eigen::Index i = 0; i < y.size(); ++i) y[i] += t == 0.0 ? 0.0 : 0.1 + 0.01 * static_cast<double>(i);
    const double force = equation.force(t, y), factor = equation.factor(t, y);
    for (Eigen::Index i = 0; i < y.size(); ++i) {
      const double value = y[i];
      y[i] += 0.1 * std::max(1.0, std::abs(value));
      const bool moves = equation.force(t, y) != force || equation.factor(t, y) != factor;
      y[i] = value;
      const bool term = i >= chain.first_row() && i < chain.first_row() + chain.size() &&
                        chain.coefficients()[i - chain.first_row()] != 0.0;
      if (moves || (factor != 1.0 && term)) rows.push_back(i);
    }
  }
  return rows;
}

std::vector<Eigen::Index> rows_read(const Problem& problem) {
  std::vector<Eigen::Index> rows;
  for (const auto& equation : problem.equations) {
    const auto read = rows_read(problem, equation, chain_of(problem, equation));
    rows.insert(rows.end(), read.begin(), read.end());
  }
  return rows;
}

// The powers of t with which g starts: the powers of the rows on which it depends, and those of its explicit
// dependence on t, inferred from u: a power p of u is a power p - L of D^L u, which must occur in a term or
// in g.
Powers powers_of_force(const Problem& problem, const Smoothness& smoothness, const Equation& equation,
                       const Chain& chain) {
  Powers powers, explained;
  for (const auto row : rows_read(problem, equation, chain)) {
    const auto& of_row = powers_of(smoothness, row);
    powers.insert(powers.end(), of_row.begin(), of_row.end());
  }
  const double leading = chain.leading().order;
  const auto& of_unknown = powers_of(smoothness, chain.first_row());
  for (const auto& term : chain.terms()) {
    explained.push_back(-term.order);
    for (const double p : of_unknown) explained.push_back(p - term.order);
  }
  std::ranges::sort(explained);
  for (const double p : of_unknown) {
    if (p > leading && !contains(explained, p - leading)) powers.push_back(p - leading);
  }
  return powers;
}

// Contributions to the error as the rows of a problem: their orders, and how they start.
struct Contributions {
  Problem problem;
  Smoothness smoothness;

  // breaks: the powers of the samples at their breaking points.
  void add(double order, const Powers& powers, bool hidden, const Powers& breaks) {
    const Eigen::Index row = problem.size();
    problem.components.push_back({order, {}});
    Powers shifted;
    for (const double q : powers) shifted.push_back(q + order);
    smoothness.powers.push_back(shifted);
    if (hidden) smoothness.unmeasured.push_back(row);
    for (const double power : breaks) smoothness.breaking_points.push_back({row, power});
  }
};

// Those of the force of the equation.
Powers breaks_of(const Smoothness& smoothness, const Chain& chain) {
  Powers powers;
  for (const auto& [row, power] : smoothness.breaking_points)
    if (row >= chain.first_row() && row < chain.first_row() + chain.size()) powers.push_back(power);
  return powers;
}

// The contributions of the samples of every sum: D^v d in a sum of the order L - a of the largest term, and g
// in those of the orders L - v.
Contributions of_samples(const Problem& problem, const Smoothness& smoothness) {
  Contributions all;
  const auto read = rows_read(problem);
  const auto chains = chains_of(problem);
  for (std::size_t e = 0; e < chains.size(); ++e) {
    const Chain& chain = chains[e];
    const double leading = chain.leading().order;
    const auto terms = chain.terms();
    const Powers of_force = powers_of_force(problem, smoothness, problem.equations[e], chain);
    for (Eigen::Index i = 0; i < chain.size(); ++i) {
      const double node = chain.nodes()[static_cast<std::size_t>(i)];
      const auto row = chain.first_row() + i;
      const bool hidden = listed(smoothness.unmeasured, row);
      if (hidden && !listed(read, row)) continue;  // nothing depends on it
      const Powers own = without_taylor(powers_of(smoothness, row), chain, node);
      if (!terms.empty()) all.add(leading - terms.back().order, own, hidden, {});
      all.add(leading - node, of_force, hidden, breaks_of(smoothness, chain));
    }
  }
  return all;
}

}  // namespace

double multi_term_trapezoidal_rate(const Problem& problem, const Smoothness& smoothness, double grading,
                                   Norm norm) {
  const auto samples = of_samples(problem, smoothness);
  return rate(trapezoidal_theory, samples.problem, samples.smoothness, grading, norm);
}

double multi_term_multistep_rate(const WeightFamily& family, const Problem& problem,
                                 const Smoothness& smoothness, double grading, Norm norm) {
  const auto samples = of_samples(problem, smoothness);
  return multistep_rate(family, starting_powers_of_equations(family, problem), samples.problem,
                        samples.smoothness, grading, norm);
}

double multi_term_grunwald_letnikov_rate(const Problem& problem, const Smoothness& smoothness, double grading,
                                         Norm norm) {
  Contributions all;
  for (const auto& chain : chains_of(problem)) {
    for (Eigen::Index i = 0; i < chain.size(); ++i) {
      const double node = chain.nodes()[static_cast<std::size_t>(i)], order = chain.leading().order - node;
      const auto row = chain.first_row() + i;
      Powers powers = without_taylor(powers_of(smoothness, row), chain, node);
      for (double& q : powers) q -= order;
      all.add(order, powers, listed(smoothness.unmeasured, row), breaks_of(smoothness, chain));
    }
  }
  return rate(grunwald_letnikov_theory, all.problem, all.smoothness, grading, norm);
}

}  // namespace fde
