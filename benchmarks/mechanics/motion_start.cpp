// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/mechanics/motion_start.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <utility>

namespace fde::bench::mechanics {
namespace {

Matrix matrix_at(const Dynamics& dynamics, const ExpressionMatrix& of, In columns) {
  const Vec values = values_at(dynamics.algebra().pool(), of.entries, 0.0, columns);
  Matrix matrix(static_cast<Eigen::Index>(of.rows), static_cast<Eigen::Index>(of.columns));
  for (Eigen::Index i = 0; i < matrix.rows(); ++i)
    for (Eigen::Index j = 0; j < matrix.cols(); ++j) matrix(i, j) = values[i * matrix.cols() + j];
  return matrix;
}

// The constraints as they are given, w = 0 and the reaction directions, at t = 0 and the velocity v.
struct ConstraintsAtStart {
  Vec columns, value;
  Matrix directions;

  ConstraintsAtStart(const Dynamics& dynamics, const Vec& velocity)
      : columns(Vec::Zero(static_cast<Eigen::Index>(dynamics.system().column_count()))) {
    const auto& system = dynamics.system();
    const auto& algebra = dynamics.algebra();
    columns << system.position, velocity, Vec::Zero(std::ssize(system.memory));
    value = values_at(algebra.pool(), system.constraints, 0.0, columns);
    directions = matrix_at(dynamics, algebra.jacobian(system.constraints, system.v()), columns);
  }

  // The directions as velocities. Precondition: there is a constraint.
  [[nodiscard]] Matrix raised(const Dynamics& dynamics) const {
    return matrix_at(dynamics, dynamics.metric(), columns).lu().solve(directions.transpose());
  }
};

// The velocity nearest to v(0) with f(0, q, v, w = 0) = 0.
Vec nearest_velocity(const Dynamics& dynamics) {
  return velocity_on_constraints(dynamics.system().velocity, [&](const Vec& velocity) -> Vec {
    const ConstraintsAtStart now(dynamics, velocity);
    const Matrix raised = now.raised(dynamics);
    return -raised * (now.directions * raised).lu().solve(now.value);
  });
}

// Whether a matrix is singular to rounding, whatever the units of its rows and columns; false if it is not
// finite, in which case a run fails.
bool is_singular(Matrix matrix) {
  if (!matrix.allFinite()) return false;
  for (auto row : matrix.rowwise())
    if (const double size = row.cwiseAbs().maxCoeff(); size > 0.0) row /= size;
  for (auto column : matrix.colwise())
    if (const double size = column.cwiseAbs().maxCoeff(); size > 0.0) column /= size;
  return Eigen::FullPivLU<Matrix>(matrix).rank() < matrix.rows();
}

std::string velocity_text(const MechanicalSystem& system, const Vec& velocity) {
  std::vector<std::string> parts;
  for (std::size_t i = 0; i < system.size(); ++i) {
    parts.push_back(
        fmt::format("D({},1) = {}", system.coordinates[i], velocity[static_cast<Eigen::Index>(i)]));
  }
  return fmt::format("{}", fmt::join(parts, ", "));
}

}  // namespace

Vec velocity_on_constraints(Vec velocity, const std::function<Vec(const Vec& velocity)>& step) {
  constexpr int most_steps = 50;
  constexpr double rounding = 1e-15;
  for (int i = 0; i < most_steps; ++i) {
    const Vec moved = step(velocity);
    velocity += moved;
    if (!(moved.norm() > rounding * velocity.norm())) break;
  }
  return velocity;
}

Vec at_start(const Dynamics& dynamics, const Expressions& of) {
  return values_at(dynamics.algebra().pool(), of, 0.0, columns_at_start(dynamics.system()));
}

std::map<double, Vec> singular_directions(const Dynamics& dynamics) {
  const auto& system = dynamics.system();
  const Matrix jacobian = matrix_at(dynamics, dynamics.memory_jacobian(), columns_at_start(system));
  std::map<double, std::pair<Vec, Vec>> defects;  // sums of terms, and of their absolute values
  for (std::size_t k = 0; k < system.memory.size(); ++k) {
    const auto& [coordinate, order] = system.memory[k];
    if (order >= 1.0) continue;
    const Vec term =
        jacobian.col(static_cast<Eigen::Index>(k)) * system.velocity[static_cast<Eigen::Index>(coordinate)];
    auto& [sum, size] =
        defects.try_emplace(order, Vec::Zero(term.size()), Vec::Zero(term.size())).first->second;
    sum += term;
    size += term.cwiseAbs();
  }
  std::map<double, Vec> directions;
  for (auto& [order, defect] : defects) {
    auto& [sum, size] = defect;
    for (Eigen::Index i = 0; i < sum.size(); ++i) sum[i] = zero_if_rounding(sum[i], size[i]);
    if (!sum.isZero(0.0))
      directions[order] = at_start(dynamics, dynamics.compensation(dynamics.algebra().numbers(sum)));
  }
  return directions;
}

ReactionStart reaction_start(const Dynamics& dynamics) {
  constexpr double rounding = 1e-12;
  const auto singular = singular_directions(dynamics);
  if (singular.empty()) return ReactionStart::regular;
  const auto& system = dynamics.system();
  const auto n = system.velocity.size();
  Vec after = columns_at_start(system);
  for (const auto& [order, direction] : singular) after.segment(n, n) += direction;
  for (std::size_t k = 0; k < system.memory.size(); ++k) {
    after[2 * n + static_cast<Eigen::Index>(k)] =
        system.velocity[static_cast<Eigen::Index>(system.memory[k].coordinate)];
  }
  const auto& algebra = dynamics.algebra();
  const Matrix moved = matrix_at(dynamics, dynamics.reaction_directions(), after);
  const Matrix metric = matrix_at(dynamics, dynamics.metric(), columns_at_start(system));
  for (Eigen::Index i = 0; i < moved.rows(); ++i) {
    const Vec direction = metric.lu().solve(moved.row(i).transpose());
    if (at_start(dynamics, dynamics.projected(algebra.numbers(direction))).norm() >
        rounding * direction.norm())
      return ReactionStart::singular_with_varying_direction;
  }
  return ReactionStart::singular;
}

Vec consistent_velocity(const Dynamics& dynamics) {
  const auto& system = dynamics.system();
  const bool jumps =
      std::ranges::any_of(system.memory, [](const MemoryTerm& term) { return term.order == 1.0; });
  if (!jumps || !dynamics.has_constraints()) return system.velocity;
  return system.velocity + at_start(dynamics, dynamics.compensation(dynamics.constraint()));
}

Vec projected_velocity(const Dynamics& dynamics) {
  const Vec& velocity = dynamics.system().velocity;
  const Vec nearest = nearest_velocity(dynamics), jumped = consistent_velocity(dynamics);
  const bool jumps = jumped != velocity;
  const Vec& chosen = jumps && (jumped - velocity).norm() < (nearest - velocity).norm() ? jumped : nearest;
  return chosen.allFinite() ? chosen : velocity;
}

Vec initial_multiplier(const Dynamics& dynamics) {
  if (!singular_directions(dynamics).empty()) return Vec::Zero(std::ssize(dynamics.constraint()));
  return at_start(dynamics, dynamics.regular_multiplier());
}

void require_regular_start(const Dynamics& dynamics) {
  const auto& system = dynamics.system();
  Vec columns = columns_at_start(system);
  columns.tail(std::ssize(system.memory)).setZero();
  const Matrix metric = matrix_at(dynamics, dynamics.metric(), columns);
  if (is_singular(metric)) {
    throw std::invalid_argument(
        "its second derivatives with respect to the velocities are a singular matrix at t = 0: must be "
        "regular, as with a "
        "square of each velocity");
  }
  if (!dynamics.has_constraints()) return;
  const Matrix reactions = matrix_at(dynamics, dynamics.reaction_directions(), columns),
               rates = matrix_at(dynamics, dynamics.acceleration_jacobian(), columns);
  for (Eigen::Index i = 0; i < reactions.rows(); ++i) {
    if (reactions.row(i).isZero(0.0)) {
      throw ConstraintError(
          static_cast<std::size_t>(i),
          "does not depend on a velocity at t = 0: must contain D(x, 1) of a coordinate, so that it has a "
          "reaction; x^2 + y^2 = 1 is written as its derivative, x*D(x,1) + y*D(y,1)");
    }
    const Matrix first = rates.topRows(i + 1) * metric.lu().solve(reactions.topRows(i + 1).transpose());
    if (is_singular(first)) {
      throw ConstraintError(static_cast<std::size_t>(i),
                            "depends on the constraints before it at t = 0: must be independent of them");
    }
  }
}

void require_start_on_constraints(const Dynamics& dynamics) {
  constexpr double rounding = 1e-10;
  const Vec& velocity = dynamics.system().velocity;
  const ConstraintsAtStart now(dynamics, velocity);
  const Vec without = ConstraintsAtStart(dynamics, Vec::Zero(velocity.size())).value;
  const Vec size = now.directions.cwiseAbs() * velocity.cwiseAbs() + without.cwiseAbs();
  const Vec at_order_one =
      at_start(dynamics, dynamics.constraint());  // the same without memory terms of order 1
  for (Eigen::Index i = 0; i < now.value.size(); ++i) {
    const double value = std::min(std::abs(now.value[i]), std::abs(at_order_one[i]));
    if (!std::isfinite(value) || value <= rounding * size[i]) continue;  // not finite: a run says so
    throw StartError(
        static_cast<std::size_t>(i),
        fmt::format(
            "is {:.6g} at t = 0: must be 0 with these initial values; the nearest velocity with this is {}",
            now.value[i], velocity_text(dynamics.system(), nearest_velocity(dynamics))));
  }
}

}  // namespace fde::bench::mechanics
