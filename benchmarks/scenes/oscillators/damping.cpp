// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/scenes/oscillators/damping.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace fde::bench {
namespace {

// In the order beta, 1, alpha.
std::vector<Term> damping_terms(const Parameters& p, const DampingWeights& weights) {
  const double tau = p["tau"], alpha = p["alpha"], beta = p["beta"];
  return {{weights.nu * std::pow(tau, beta), beta},
          {weights.lambda * tau, 1.0},
          {weights.mu * std::pow(tau, alpha), alpha}};
}

constexpr double leading_order = 2.0;

// u'' plus the damping term of order 2, if any.
Term leading_term(const std::vector<Term>& terms) {
  Term leading{1.0, leading_order};
  for (const auto& term : terms) {
    if (term.order == leading_order) leading.coefficient += term.coefficient;
  }
  return leading;
}

std::vector<Term> lower_terms(std::vector<Term> terms) {
  std::erase_if(terms, [](const Term& term) { return term.order == leading_order; });
  return terms;
}

}  // namespace

std::vector<Parameter> damping_parameters(const std::vector<Parameter>& others) {
  std::vector<Parameter> all{
      {"alpha",
       1.5,
       {.low = 1.0, .high = 2.0},
       "higher order of damping; at 1 not the limit from above; of order 2 it is inertia"},
      {"beta", 0.5, {.low = 0.0, .high = 1.0}, "lower order of damping; at 0 not the limit from above"},
      {"tau", 0.8, positive, "relaxation time"}};
  all.insert(all.end(), others.begin(), others.end());
  return all;
}

DampedUnknown::DampedUnknown(const std::string& u, const Parameters& p, const DampingWeights& weights,
                             const std::vector<double>& initial, const UnknownOffset& first)
    : chain_(leading_term(damping_terms(p, weights)), lower_terms(damping_terms(p, weights)), initial,
             first.row),
      first_column_(first.column) {
  const auto terms = damping_terms(p, weights);
  const auto &lower = terms[0], &middle = terms[1], &higher = terms[2];
  if (lower.order == 0.0 && lower.coefficient * initial[0] != 0.0)
    discontinuities_.push_back({"beta", fmt::format("D^beta {0} tends to {0} - {0}(0)", u)});
  if (higher.order == 1.0 && higher.coefficient * initial[1] != 0.0)
    discontinuities_.push_back({"alpha", fmt::format("D^alpha {0} tends to {0}' - {0}'(0)", u)});
  add_column(u, 0.0, 0.0);
  if (lower.coefficient != 0.0) add_column("Dbeta_" + u, lower.order, lower.coefficient);
  column_of_velocity_ = next().column;
  add_column("d" + u, middle.order, middle.coefficient);
  if (higher.coefficient != 0.0) add_column("Dalpha_" + u, higher.order, higher.coefficient);
}

void DampedUnknown::add_column(const std::string& name, double order, double weight) {
  names_.push_back(name);
  orders_.push_back(order);
  weights_.push_back(weight);
}

std::vector<DampedUnknown::ColumnSource> DampedUnknown::column_sources() const {
  std::vector<ColumnSource> columns;
  for (const double order : orders_) {
    const bool acceleration = order == leading_order;
    columns.push_back(
        {acceleration ? chain_.first_row() + chain_.size() - 1 : *chain_.row(order), acceleration});
  }
  return columns;
}

UnknownOffset DampedUnknown::next() const {
  return {.row = chain_.first_row() + chain_.size(), .column = first_column_ + std::ssize(names_)};
}

double DampedUnknown::power(In columns) const {
  const Eigen::Map<const Vec> weights(weights_.data(), std::ssize(weights_));
  return -du(columns) * weights.dot(columns.segment(first_column_, weights.size()));
}

Outputs outputs_of(const std::vector<DampedUnknown>& unknowns, const Problem& problem) {
  std::vector<std::string> names;
  std::vector<DampedUnknown::ColumnSource> shown;
  for (const auto& unknown : unknowns) {
    std::ranges::copy(unknown.names(), std::back_inserter(names));
    const auto columns = unknown.column_sources();
    shown.insert(shown.end(), columns.begin(), columns.end());
  }
  if (std::ranges::none_of(shown, &DampedUnknown::ColumnSource::acceleration)) {
    std::vector<Eigen::Index> rows;
    for (const auto& column : shown) rows.push_back(column.row);
    return select_components(names, rows);
  }
  return {names, [shown, rhs = problem.rhs](double t, In y, Out columns) {
            Vec f(y.size());
            rhs(t, y, f);
            for (Eigen::Index c = 0; c < columns.size(); ++c) {
              const auto& [row, acceleration] = shown[static_cast<std::size_t>(c)];
              columns[c] = acceleration ? f[row] : y[row];
            }
          }};
}

}  // namespace fde::bench
