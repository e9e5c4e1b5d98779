#include "scenes/oscillators/damping.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace fde {
namespace {

// beta, 1, alpha.
std::vector<Term> damping_terms(const Parameters& p, const DampingWeights& weights) {
  const double tau = p["tau"], alpha = p["alpha"], beta = p["beta"];
  return {{weights.nu * std::pow(tau, beta), beta},
          {weights.lambda * tau, 1.0},
          {weights.mu * std::pow(tau, alpha), alpha}};
}

}  // namespace

std::vector<Parameter> damping_parameters(const std::vector<Parameter>& others) {
  std::vector<Parameter> all{
      {"alpha", 1.5, {.low = 1.0, .high = 2.0, .open_high = true}, "higher order of damping"},
      {"beta", 0.5, {.low = 0.0, .high = 1.0}, "lower order of damping"},
      {"tau", 0.8, positive, "relaxation time"}};
  all.insert(all.end(), others.begin(), others.end());
  return all;
}

DampedUnknown::DampedUnknown(const std::string& u, const Parameters& p, const DampingWeights& weights,
                             std::vector<double> initial, const FirstOf& first)
    : chain_({1.0, 2.0}, damping_terms(p, weights), std::move(initial), first.row),
      first_column_(first.column) {
  const auto terms = damping_terms(p, weights);
  const auto &lower = terms[0], &middle = terms[1], &higher = terms[2];
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

std::vector<Eigen::Index> DampedUnknown::rows() const {
  std::vector<Eigen::Index> rows;
  for (const double order : orders_) rows.push_back(*chain_.row(order));
  return rows;
}

FirstOf DampedUnknown::next() const {
  return {.row = chain_.first() + chain_.size(), .column = first_column_ + std::ssize(names_)};
}

double DampedUnknown::power(In columns) const {
  const Eigen::Map<const Vec> weights(weights_.data(), std::ssize(weights_));
  return -du(columns) * weights.dot(columns.segment(first_column_, weights.size()));
}

Outputs outputs_of(const std::vector<DampedUnknown>& unknowns) {
  std::vector<std::string> names;
  std::vector<Eigen::Index> rows;
  for (const auto& unknown : unknowns) {
    std::ranges::copy(unknown.names(), std::back_inserter(names));
    std::ranges::copy(unknown.rows(), std::back_inserter(rows));
  }
  return picked(names, rows);
}

}  // namespace fde
