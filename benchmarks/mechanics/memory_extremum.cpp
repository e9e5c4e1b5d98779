// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/mechanics/memory_extremum.hpp"

#include <algorithm>
#include <boost/math/special_functions/beta.hpp>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "fdebench/benchmarks/expressions/program.hpp"
#include "fdebench/benchmarks/mechanics/motion_start.hpp"
#include "fdebench/schemes/problem/smoothness.hpp"

namespace fde::bench::mechanics {
namespace {

// S with T = 1, by the substitution x = (t - s) / (1 - s) and integration by parts: B_t is the incomplete
// beta function in
//   t^a - (1 - a) (1 - t)^(2a - 1) B_t(a, 2 - 2a).
double singular_part(double order, double t) {
  const double beta = t > 0.0 ? boost::math::beta(order, 2.0 - 2.0 * order, t) : 0.0;
  return std::pow(t, order) - (1.0 - order) * std::pow(1.0 - t, 2.0 * order - 1.0) * beta;
}

// The rows y, pi and c, one of each a coordinate, with S as the variable after them.
class MemoryRows {
 public:
  MemoryRows(const MechanicalSystem& system, const Algebra& algebra) : system_(system), algebra_(algebra) {
    const auto n = static_cast<int>(system.size());
    const auto variables = [&](int first) {
      Expressions all;
      for (int i = 0; i < n; ++i) all.push_back(algebra.pool().variable(first + i + 1));
      return all;
    };
    const auto y = variables(0), pi = variables(n), c = variables(2 * n);
    const auto singular = algebra.pool().variable(3 * n + 1);
    position_ = algebra.sum(y, algebra.product(singular, c));
    const auto momenta = algebra.gradient(system.lagrangian, ordered_memory());
    const auto stiffness = algebra.jacobian(momenta, ordered_memory());
    const auto slope = algebra.gradient(system.lagrangian, system.q());
    require_regular(stiffness, slope);
    rows_ = algebra.solve(stiffness, algebra.difference(pi, at_position(without_memory(momenta))));
    for (const auto e : algebra.negative(at_position(slope))) rows_.push_back(e);
    rows_.resize(3 * system.size(), algebra.zero());
  }

  [[nodiscard]] const Expressions& rows() const { return rows_; }
  [[nodiscard]] const Expressions& position() const { return position_; }
  // Whether y and pi are 0: then L is a quadratic form in w.
  [[nodiscard]] bool is_singular_part_alone() const {
    return system_.position.isZero(0.0) &&
           std::all_of(rows_.begin() + static_cast<std::ptrdiff_t>(system_.size()), rows_.end(),
                       [&](Expression e) { return algebra_.is_zero(e); }) &&
           std::ranges::all_of(without_memory(algebra_.gradient(system_.lagrangian, ordered_memory())),
                               [&](Expression e) { return algebra_.is_zero(e); });
  }

 private:
  // The variables of the memory terms in the order of the coordinates.
  [[nodiscard]] std::vector<int> ordered_memory() const {
    std::vector<int> variables(system_.size());
    for (std::size_t k = 0; k < system_.memory.size(); ++k)
      variables[system_.memory[k].coordinate] = system_.w()[k];
    return variables;
  }
  [[nodiscard]] Expressions without_memory(const Expressions& of) const {
    return algebra_.pool().substituted(of, [&](int variable) {
      return variable > static_cast<int>(system_.size()) ? algebra_.zero()
                                                         : algebra_.pool().variable(variable);
    });
  }
  [[nodiscard]] Expressions at_position(const Expressions& of) const {
    return algebra_.pool().substituted(of, [&](int variable) {
      return variable == 0 ? algebra_.pool().variable(0) : position_[static_cast<std::size_t>(variable) - 1];
    });
  }
  void require_regular(const ExpressionMatrix& stiffness, const Expressions& slope) const {
    for (const auto e : stiffness.entries) {
      if (!algebra_.pool().value(e))
        throw std::invalid_argument("must be quadratic in D(x, a) with constant coefficients");
    }
    for (const auto e : slope) {
      for (const int w : system_.w()) {
        if (algebra_.pool().depends_on(e, w))
          throw std::invalid_argument("must have no product of D(x, a) with a function of a coordinate");
      }
    }
  }

  const MechanicalSystem& system_;
  const Algebra& algebra_;
  Expressions position_{}, rows_{};
};

// A program of y and S(t), with S as the variable after y.
class ProgramOfSingularPart {
 public:
  ProgramOfSingularPart(const ExpressionPool& pool, const Expressions& of, Eigen::Index size, double order,
                        double end)
      : program_(pool, of, size + 1), order_(order), end_(end) {}

  void operator()(double t, In y, Out results) const {
    Vec all(y.size() + 1);
    all << y, singular_part(order_, std::min(t / end_, 1.0));
    program_(t, all, results);
  }

 private:
  Program program_;
  double order_, end_;
};

std::vector<Component> components_of(const MechanicalSystem& system, const ExtremumEnds& ends, double order) {
  std::vector<Component> components;
  for (const double value : system.position) components.push_back({order, {value}});
  for (std::size_t i = 0; i < system.size(); ++i) components.push_back({order, {0.0}, Side::right});
  for (const auto& last : ends.final)
    components.push_back({1.0, last ? std::vector<double>{} : std::vector{0.0}});
  return components;
}

// y(T) + c = q(T) where this is given.
std::function<void(In, In, Out)> conditions_of(const ExtremumEnds& ends) {
  std::vector<std::pair<Eigen::Index, double>> given;
  for (std::size_t i = 0; i < ends.final.size(); ++i)
    if (ends.final[i]) given.emplace_back(static_cast<Eigen::Index>(i), *ends.final[i]);
  if (given.empty()) return {};
  return [given, n = std::ssize(ends.final)](In, In at_end, Out residual) {
    for (std::size_t k = 0; k < given.size(); ++k) {
      const auto& [i, last] = given[k];
      residual[static_cast<Eigen::Index>(k)] = at_end[i] + at_end[2 * n + i] - last;
    }
  };
}

DenseJacobian jacobian_of(const Expressions& rows, const Algebra& algebra, double order, double end) {
  const auto size = std::ssize(rows);
  std::vector<int> variables;
  for (int i = 1; i <= static_cast<int>(size); ++i) variables.push_back(i);
  const auto by_columns = algebra.transposed(algebra.jacobian(rows, variables)).entries;
  return {[size, program = ProgramOfSingularPart(algebra.pool(), by_columns, size, order, end)](
              double t, In y, OutMatrix jacobian) {
    Vec entries(size * size);
    program(t, y, entries);
    jacobian = entries.reshaped(size, size);
  }};
}

// y starts like t^a and ends like (T - t)^(2a - 1); both rows have q in their right-hand sides.
Smoothness smoothness_of(std::size_t n, double order, bool regular_part) {
  Smoothness smoothness;
  smoothness.powers.resize(3 * n);
  for (std::size_t i = 0; i < n && regular_part; ++i) {
    smoothness.powers[i] = power_lattice({order}, {1.0, 2.0 * order}, order + 2.0);
    smoothness.powers[n + i] = power_lattice({order}, {1.0, 2.0 * order - 1.0}, order + 2.0);
  }
  return smoothness;
}

}  // namespace

bool is_memory_lagrangian(const MechanicalSystem& system, ExpressionPool& pool) {
  if (system.memory.empty()) return false;
  return std::ranges::none_of(system.v(), [&](int v) { return pool.depends_on(system.lagrangian, v); });
}

Scene memory_extremum_scene(const MechanicalSystem& system, const ExtremumEnds& ends,
                            const std::vector<std::string>& names, double end, ExpressionPool& pool) {
  const double order = system.memory.front().order;
  const bool one_each =
      system.memory.size() == system.size() &&
      std::ranges::all_of(system.memory, [&](const MemoryTerm& term) { return term.order == order; });
  if (!one_each)
    throw std::invalid_argument("without velocities must have D(x, a) of each coordinate, of one order a");
  if (order <= 0.5) throw std::invalid_argument("without velocities must have D(x, a) with a above 1/2");
  if (!system.constraints.empty())
    throw ConstraintError(0, "must not be there in a Lagrangian without velocities");
  const Algebra algebra(pool);
  const MemoryRows of(system, algebra);
  const auto size = std::ssize(of.rows());
  Scene scene;
  scene.problem = {.components = components_of(system, ends, order),
                   .rhs = ProgramOfSingularPart(pool, of.rows(), size, order, end),
                   .derivatives = jacobian_of(of.rows(), algebra, order, end),
                   .end = end,
                   .conditions = conditions_of(ends)};
  scene.outputs = {names, ProgramOfSingularPart(pool, of.position(), size, order, end)};
  scene.smoothness = smoothness_of(system.size(), order, !of.is_singular_part_alone());
  return scene;
}

}  // namespace fde::bench::mechanics
