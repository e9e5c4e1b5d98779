// SPDX-License-Identifier: MIT
#include "fdebench/schemes/rules/multi_term/integrated_equations.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "fdebench/schemes/problem/chain.hpp"
#include "fdebench/schemes/problem/smoothness.hpp"
#include "fdebench/schemes/solvers/dense_factors.hpp"

namespace fde {
namespace {

// c_k / a, of each row of the chain.
Vec ratios_of(const Chain& chain) { return chain.coefficients() / chain.leading().coefficient; }

// g / a in all rows of each chain.
void evaluate(const Problem& problem, const std::vector<Chain>& chains, double t, In y, Out f) {
  for (std::size_t e = 0; e < chains.size(); ++e) {
    const auto& chain = chains[e];
    const auto& equation = problem.equations[e];
    double g = equation.force(t, y);
    if (const double factor = equation.factor(t, y); factor != 1.0)
      g += (1.0 - factor) * chain.coefficients().dot(y.segment(chain.first_row(), chain.size()));
    f.segment(chain.first_row(), chain.size()).setConstant(g / chain.leading().coefficient);
  }
}

// The last row of a chain is D^L u = (g - sum_k c_k D^(a_k) u) / a.
void differentiate(const Problem& problem, const std::vector<Chain>& chains, double t, In y,
                   OutMatrix jacobian) {
  evaluate_jacobian(problem, t, y, jacobian);
  for (const auto& chain : chains) {
    const auto first = chain.first_row(), size = chain.size();
    Eigen::RowVectorXd row = jacobian.row(first + size - 1);
    row.segment(first, size) += ratios_of(chain).transpose();
    jacobian.middleRows(first, size).rowwise() = row;
  }
}

Derivatives integrated_derivatives(const Problem& problem, const std::vector<Chain>& chains) {
  if (!has_jacobian(problem)) return NoDerivatives{};
  if (!is_linear(problem)) {
    return DenseJacobian{[=, &problem](double t, In y, OutMatrix jacobian) {
      differentiate(problem, chains, t, y, jacobian);
    }};
  }
  DenseLinearPart part{Matrix(problem.size(), problem.size())};
  differentiate(problem, chains, 0.0, Vec::Zero(problem.size()), part.matrix);
  return part;
}

// The rows D^v u as components of order L - v.
std::vector<Component> integrated_components(const Problem& problem, const std::vector<Chain>& chains) {
  std::vector<Component> components = problem.components;
  for (const auto& chain : chains) {
    for (Eigen::Index i = 0; i < chain.size(); ++i) {
      auto& [order, initial, side] = components[static_cast<std::size_t>(chain.first_row() + i)];
      order = chain.leading().order - chain.nodes()[static_cast<std::size_t>(i)];
      initial.resize(initial_count(order), 0.0);
    }
  }
  return components;
}

}  // namespace

std::vector<Chain> chains_of(const Problem& problem) {
  std::vector<Chain> chains;
  for (const auto& equation : problem.equations) chains.push_back(chain_of(problem, equation));
  return chains;
}

std::optional<std::string> unsupported_equations_reason(const Problem& problem) {
  Eigen::Index rows = 0;
  for (const auto& chain : chains_of(problem)) {
    const double leading = chain.leading().order;
    if (leading > 2.0) return fmt::format("takes leading orders up to 2, not {}", leading);
    rows += chain.size();
  }
  if (rows == problem.size()) return std::nullopt;
  return fmt::format("discretises multi-term equations only: {} of {} rows are of none",
                     problem.size() - rows, problem.size());
}

Problem integrated_problem(const Problem& problem) {
  const auto chains = chains_of(problem);
  return {.components = integrated_components(problem, chains),
          .rhs = [=, &problem](double t, In y, Out f) { evaluate(problem, chains, t, y, f); },
          .derivatives = integrated_derivatives(problem, chains),
          .end = problem.end,
          .domain = problem.domain,
          .jump_times = problem.jump_times};
}

StartingPowers starting_powers_of_equations(const WeightFamily& family, const Problem& problem) {
  std::vector<double> orders, steps;
  for (const auto& chain : chains_of(problem)) {
    for (const double node : chain.nodes()) {
      orders.push_back(chain.leading().order - node);
      steps.push_back(orders.back());
      if (!is_integer_order(node)) steps.push_back(std::ceil(node) - node);  // D^v T, where g depends on it
    }
  }
  return starting_powers(family, orders, steps);
}

IntegratedEquations::IntegratedEquations(const Problem& problem, const WeightFamily& family, const Grid& grid,
                                         const Options& options, const std::vector<double>& starting_powers)
    : grid_(grid),
      parts_(chain_sums(problem)),
      tables_(tables(family)),
      history_(make_history(options.history, tables_, step_plan(grid), options.newton_tolerance)),
      factors_(Matrix::Zero(std::ssize(parts_), std::ssize(tables_))),
      sums_(std::ssize(tables_.front()), std::ssize(tables_)),
      sample_(sums_.rows()),
      taylor_derivatives_(problem.size()),
      taylor_integrals_(problem.size()),
      known_(problem.size()),
      kappa_(Vec::Zero(problem.size())) {
  if (starting_powers.empty()) return;
  for (auto of_sum : tables_) {
    // Rows that are not in a sum get the table of one that is; their sums are not used.
    const auto used = *std::ranges::find_if(of_sum, [](const auto& table) { return table.order > 0.0; });
    std::ranges::replace_if(
        of_sum, [](const auto& table) { return table.order == 0.0; }, used);
    corrections_.emplace_back(of_sum, starting_powers, grid.steps);
  }
}

std::size_t IntegratedEquations::bytes() const {
  std::size_t bytes = history_->bytes();
  for (const auto& correction : corrections_) bytes += correction.bytes();
  return bytes;
}

std::vector<IntegratedEquations::ChainSum> IntegratedEquations::chain_sums(const Problem& problem) {
  std::vector<ChainSum> parts;
  Eigen::Index first = 0;
  for (const auto& chain : chains_of(problem)) {
    parts.push_back({chain, ratios_of(chain), first, TaylorPartIntegrals(chain)});
    first += chain.size() + 1;
  }
  return parts;
}

WeightTables IntegratedEquations::tables(const WeightFamily& family) const {
  Eigen::Index sums = 0;
  for (const auto& part : parts_) sums = std::max(sums, part.chain.size());
  WeightTables all(static_cast<std::size_t>(sums));
  for (Eigen::Index i = 0; i < sums; ++i) {
    auto& of_sum = all[static_cast<std::size_t>(i)];
    for (const auto& [chain, ratios, first, starts, own] : parts_) {
      const bool used = i < chain.size();  // order 0: there is nothing to sum
      const double order = used ? chain.leading().order - chain.nodes()[static_cast<std::size_t>(i)] : 0.0;
      const bool term = used && ratios[i] != 0.0;
      of_sum.insert(of_sum.end(), static_cast<std::size_t>(chain.size()), {&family, term ? order : 0.0});
      of_sum.push_back({&family, order});
    }
  }
  return all;
}

Matrix IntegratedEquations::first_weights_of(const ChainSum& part, Eigen::Index i) const {
  const auto& correction = corrections_[static_cast<std::size_t>(i)];
  return correction.first_weights(
      correction.tables_of_rows()[static_cast<std::size_t>(part.first + part.chain.size())]);
}

// The rows of an equation satisfy A D^v d = kappa_v Omega_v f - (the integrals of D^v T) at all first
// steps together, A = 1 + sum_k c_k/a kappa_k Omega_k, and D^v d = 0 at t = 0.
std::optional<StartingEquations> IntegratedEquations::first_equations() {
  if (!compute_factors(1)) return std::nullopt;
  const auto steps = corrections_.front().count() - 1;
  StartingEquations equations{
      {}, std::vector<std::size_t>(static_cast<std::size_t>(known_.size())), Matrix(known_.size(), steps)};
  Matrix taylor_columns(known_.size(), steps);
  for (Eigen::Index n = 1; n <= steps; ++n) {
    update_taylor_part(grid_.time(static_cast<int>(n)));
    equations.known.col(n - 1) = taylor_derivatives_;
    taylor_columns.col(n - 1) = taylor_integrals_;
  }
  for (std::size_t e = 0; e < parts_.size(); ++e) {
    const auto& part = parts_[e];
    const auto factors = factors_.row(static_cast<Eigen::Index>(e));
    std::vector<Matrix> weights;
    Matrix own = Matrix::Identity(steps, steps);
    for (Eigen::Index i = 0; i < part.chain.size(); ++i) {
      weights.emplace_back(factors[i] * first_weights_of(part, i));
      own += part.ratios[i] * weights.back().rightCols(steps);
    }
    const Eigen::PartialPivLU<Matrix> factorised(own);
    for (Eigen::Index i = 0; i < part.chain.size(); ++i) {
      const auto row = part.chain.first_row() + i;
      equations.known.row(row) -= factorised.solve(taylor_columns.row(row).transpose()).transpose();
      equations.of_row[static_cast<std::size_t>(row)] = equations.weights.size();
      equations.weights.emplace_back(factorised.solve(weights[static_cast<std::size_t>(i)]));
    }
  }
  return equations;
}

void IntegratedEquations::update_taylor_part(double t) {
  if (t == time_) return;
  time_ = t;
  for (const auto& [chain, ratios, first, starts, own] : parts_) {
    starts.at(t, taylor_derivatives_.segment(chain.first_row(), chain.size()),
              taylor_integrals_.segment(chain.first_row(), chain.size()));
  }
}

void IntegratedEquations::push(double t, In y, In f) {
  update_taylor_part(t);
  for (const auto& [chain, ratios, first, starts, own] : parts_) {
    const auto rows = chain.size();
    sample_.segment(first, rows) =
        y.segment(chain.first_row(), rows) - taylor_derivatives_.segment(chain.first_row(), rows);
    sample_[first + rows] = f[chain.first_row()];
  }
  history_->push(t, sample_);
  for (auto& correction : corrections_) correction.push(sample_);
}

bool IntegratedEquations::prepare_step(int n) {
  const double t = grid_.time(n);
  update_taylor_part(t);
  if ((n == 1 || !grid_.uniform()) && !compute_factors(n)) return false;
  for (Eigen::Index i = 0; i < sums_.cols(); ++i)
    history_->convolve(t, static_cast<std::size_t>(i), sums_.col(i));
  for (std::size_t i = 0; i < corrections_.size(); ++i)
    corrections_[i].add(n, sums_.col(static_cast<Eigen::Index>(i)));
  for (std::size_t e = 0; e < parts_.size(); ++e) {
    const auto& [chain, ratios, first, starts, own] = parts_[e];
    const auto rows = chain.size();
    auto known = known_.segment(chain.first_row(), rows);
    known = -taylor_integrals_.segment(chain.first_row(), rows);
    for (Eigen::Index i = 0; i < rows; ++i) {
      const double factor = factors_(static_cast<Eigen::Index>(e), i);
      if (ratios[i] != 0.0) known -= ratios[i] * factor * sums_.col(i).segment(first, rows);
      known[i] += factor * sums_(first + rows, i);
    }
    known = taylor_derivatives_.segment(chain.first_row(), rows) + known / own;
  }
  return true;
}

bool IntegratedEquations::compute_factors(int n) {
  for (std::size_t e = 0; e < parts_.size(); ++e) {
    auto& [chain, ratios, first, starts, own] = parts_[e];
    const auto rows = chain.size();
    auto factors = factors_.row(static_cast<Eigen::Index>(e)).head(rows);
    for (Eigen::Index i = 0; i < rows; ++i) {
      const auto& of_sum = tables_[static_cast<std::size_t>(i)];
      factors[i] = step_factor(of_sum[static_cast<std::size_t>(first + rows)], grid_.step(n));
    }
    own = 1.0 + factors.dot(ratios);
    if (!(own > 0.0)) return false;
    kappa_.segment(chain.first_row(), rows) = factors.transpose() / own;
  }
  return true;
}

void IntegratedEquations::state(Archive& archive) {
  archive(history_, corrections_, factors_, kappa_);
  for (auto& part : parts_) archive(part.denominator);
}

}  // namespace fde
