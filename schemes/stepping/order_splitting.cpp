// SPDX-License-Identifier: MIT
#include "fdebench/schemes/stepping/order_splitting.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace fde {
namespace {

constexpr int largest_denominator = 64;

// position[i]: the index in the split problem of the original component i.
std::vector<Eigen::Index> positions(const OrderSplitting& links) {
  std::vector<Eigen::Index> position;
  Eigen::Index next = 0;
  for (const auto& link : links) {
    position.push_back(next);
    next += static_cast<Eigen::Index>(link.size());
  }
  return position;
}

Eigen::Index last_of(const OrderSplitting& links, const std::vector<Eigen::Index>& position, Eigen::Index i) {
  const auto index = static_cast<std::size_t>(i);
  return position[index] + static_cast<Eigen::Index>(links[index].size()) - 1;
}

Eigen::Index size_of(const OrderSplitting& links, const std::vector<Eigen::Index>& position) {
  return position.back() + static_cast<Eigen::Index>(links.back().size());
}

// The Jacobian of the split problem from the Jacobian of the original right-hand side.
void spread(const Matrix& original, const OrderSplitting& links, const std::vector<Eigen::Index>& position,
            OutMatrix jacobian) {
  jacobian.setZero();
  jacobian.diagonal(1).setOnes();
  for (Eigen::Index i = 0; i < original.rows(); ++i) {
    const auto row = last_of(links, position, i);
    jacobian.row(row).setZero();
    for (Eigen::Index j = 0; j < original.cols(); ++j) {
      jacobian(row, position[static_cast<std::size_t>(j)]) = original(i, j);
    }
  }
}

SparseMatrix spread(const SparseMatrix& original, const OrderSplitting& links,
                    const std::vector<Eigen::Index>& position) {
  std::vector<Eigen::Triplet<double>> entries;
  for (Eigen::Index i = 0; i < original.rows(); ++i) {
    for (auto link = position[static_cast<std::size_t>(i)]; link < last_of(links, position, i); ++link) {
      entries.emplace_back(link, link + 1, 1.0);
    }
  }
  for (Eigen::Index j = 0; j < original.outerSize(); ++j) {
    for (SparseMatrix::InnerIterator entry(original, j); entry; ++entry) {
      entries.emplace_back(last_of(links, position, entry.row()), position[static_cast<std::size_t>(j)],
                           entry.value());
    }
  }
  const auto size = size_of(links, position);
  SparseMatrix result(size, size);
  result.setFromTriplets(entries.begin(), entries.end());
  return result;
}

std::vector<Component> split_components(const Problem& problem, const OrderSplitting& links) {
  std::vector<Component> components;
  for (std::size_t i = 0; i < links.size(); ++i) {
    const auto& initial = problem.components[i].initial;
    double node = 0.0;
    for (const double link : links[i]) {
      components.push_back(
          {link, {is_integer_order(node) ? initial[static_cast<std::size_t>(std::lround(node))] : 0.0}});
      node += link;
    }
  }
  return components;
}

// The derivatives of the split problem, in the same form as the original ones.
Derivatives split_orders(const NoDerivatives& none, const OrderSplitting& /*links*/,
                         const std::vector<Eigen::Index>& /*position*/) {
  return none;
}
Derivatives split_orders(const DenseJacobian& original, const OrderSplitting& links,
                         const std::vector<Eigen::Index>& position) {
  return DenseJacobian{[original, links, position](double t, In y, OutMatrix jacobian) {
    const auto size = static_cast<Eigen::Index>(position.size());
    Matrix inner(size, size);
    original.at(t, Vec(y(position)), inner);
    spread(inner, links, position, jacobian);
  }};
}
Derivatives split_orders(const SparseJacobian& original, const OrderSplitting& links,
                         const std::vector<Eigen::Index>& position) {
  return SparseJacobian{[original, links, position](double t, In y, SparseMatrix& jacobian) {
    const auto size = static_cast<Eigen::Index>(position.size());
    SparseMatrix inner(size, size);
    original.at(t, Vec(y(position)), inner);
    jacobian = spread(inner, links, position);
  }};
}
Derivatives split_orders(const DenseLinearPart& original, const OrderSplitting& links,
                         const std::vector<Eigen::Index>& position) {
  const auto size = size_of(links, position);
  DenseLinearPart result{Matrix(size, size)};
  spread(original.matrix, links, position, result.matrix);
  return result;
}
Derivatives split_orders(const SparseLinearPart& original, const OrderSplitting& links,
                         const std::vector<Eigen::Index>& position) {
  return SparseLinearPart{spread(original.matrix, links, position)};
}

// Only original components are looked up. Before the start the others are 0.
template <class Write>
Delays split_orders(const Delays& original, const std::vector<Eigen::Index>& position, const Write& write) {
  return {.lags = original.lags,
          .before =
              [before = original.before, position](double t, Out y) {
                Vec values(std::ssize(position));
                before(t, values);
                y.setZero();
                y(position) = values;
              },
          .rhs =
              [rhs = original.rhs, position, write](double t, In y, const Past& past, Out f) {
                const Past original_past = [&](double time, Out value) {
                  Vec all(y.size());
                  past(time, all);
                  value = all(position);
                };
                const Vec values = y(position);
                Vec rhs_values(values.size());
                rhs(t, values, original_past, rhs_values);
                write(y, rhs_values, f);
              }};
}

// A function of the original components as one of all; empty if it is.
template <class Value>
std::function<Value(double, In)> of_original(const std::function<Value(double, In)>& function,
                                             const std::vector<Eigen::Index>& position) {
  if (!function) return {};
  return [function, position](double t, In y) { return function(t, Vec(y(position))); };
}

Trajectory solve_split(const Problem& problem, const Resolution& resolution, const Options& options,
                       const OrderSplitting& links, const Solve& solve) {
  if (std::ranges::all_of(links, [](const auto& link) { return link.size() == 1; })) {
    return solve(problem, resolution, options);
  }
  const auto position = positions(links);
  Options inner = options;
  if (options.observer) {
    inner.observer = [&](double t, In y) { options.observer(t, Vec(y(position))); };
  }
  for (auto& event : inner.events) {
    event.value = of_original(event.value, position);
  }
  if (options.wants_past) {
    inner.wants_past = [&](const Past& solution) {
      options.wants_past([&position, solution, all = Vec(size_of(links, position))](double t, Out y) mutable {
        solution(t, all);
        y = all(position);
      });
    };
  }
  Trajectory path = solve(split_orders(problem, links), resolution, inner);
  path.y = Rows(path.y(position, Eigen::all));
  for (auto& occurrence : path.events) occurrence.y = Vec(occurrence.y(position));
  if (path.dense_output) {
    path.dense_output = [dense = std::move(path.dense_output), position](double t) -> Vec {
      return dense(t)(position);
    };
  }
  return path;
}

}  // namespace

OrderSplitting splitting_up_to_one(const Problem& problem) {
  OrderSplitting links;
  for (const auto& component : problem.components) {
    if (component.order > 1.0) {
      links.push_back({1.0, component.order - 1.0});
    } else {
      links.push_back({component.order});
    }
  }
  return links;
}

std::optional<OrderSplitting> commensurate_splitting(const Problem& problem) {
  for (int m = 1; m <= largest_denominator; ++m) {
    const auto fits = [m](const Component& c) {  // an order that rounds to 0/m would have no link
      return is_algebraic(c) || (is_integer_order(c.order * m) && std::lround(c.order * m) > 0);
    };
    if (!std::ranges::all_of(problem.components, fits)) continue;
    OrderSplitting links;
    for (const auto& c : problem.components) {
      const auto count = static_cast<std::size_t>(std::lround(c.order * m));
      links.push_back(is_algebraic(c) ? std::vector{0.0} : std::vector(count, 1.0 / m));
    }
    return links;
  }
  return std::nullopt;
}

Problem split_orders(const Problem& problem, const OrderSplitting& links) {
  const auto position = positions(links);
  Problem result{.components = split_components(problem, links), .rhs = {}, .end = problem.end};
  const auto write = [links, position](In y, const Vec& original_rhs, Out f) {
    f.head(f.size() - 1) = y.tail(y.size() - 1);
    for (Eigen::Index i = 0; i < original_rhs.size(); ++i) f[last_of(links, position, i)] = original_rhs[i];
  };
  result.rhs = [rhs = problem.rhs, write, position](double t, In y, Out f) {
    const Vec original = y(position);
    Vec rhs_values(original.size());
    rhs(t, original, rhs_values);
    write(y, rhs_values, f);
  };
  if (!problem.delays.lags.empty()) result.delays = split_orders(problem.delays, position, write);
  result.jump_times = problem.jump_times;
  result.kink_times = problem.kink_times;
  result.step_limits = problem.step_limits;
  result.outputs = of_original(problem.outputs, position);
  for (const auto& one : problem.switching_functions)
    result.switching_functions.push_back(of_original(one, position));
  result.domain = {.edge = problem.domain.edge,
                   .margin = of_original(problem.domain.margin, position),
                   .constraints = of_original(problem.domain.constraints, position)};
  result.derivatives = std::visit([&](const auto& given) { return split_orders(given, links, position); },
                                  problem.derivatives);
  return result;
}

Smoothness split_orders(const Problem& problem, const Smoothness& smoothness, const OrderSplitting& links) {
  Smoothness result;
  for (std::size_t i = 0; i < links.size(); ++i) {
    std::vector<double> powers = smoothness.powers[i];
    const auto& initial = problem.components[i].initial;
    for (std::size_t k = 1; k < initial.size(); ++k) {
      if (initial[k] != 0.0) powers.insert(powers.begin(), static_cast<double>(k));
    }
    double node = 0.0;
    for (const double link : links[i]) {
      auto& node_powers = result.powers.emplace_back();
      for (const double p : powers) {
        if (p > node && !same_order(p, node)) node_powers.push_back(p - node);
      }
      node += link;
    }
    for (const auto& [row, power] : smoothness.breaking_points) {  // of the right-hand side, in the last link
      if (row == static_cast<Eigen::Index>(i))
        result.breaking_points.push_back({std::ssize(result.powers) - 1, power});
    }
  }
  return result;
}

Solve with_split_orders(std::function<OrderSplitting(const Problem&)> links, Solve solve) {
  return [links = std::move(links), solve = std::move(solve)](
             const Problem& problem, const Resolution& resolution, const Options& options) {
    return solve_split(problem, resolution, options, links(problem), solve);
  };
}

}  // namespace fde
