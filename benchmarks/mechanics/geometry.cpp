// SPDX-License-Identifier: MIT
#include <memory>
#include <utility>

#include "fdebench/benchmarks/expressions/program.hpp"
#include "fdebench/benchmarks/mechanics/mechanical_scene.hpp"

// Niminet & Blanuta 2009 with T = 1/2 g_ij y^i y^j, without the factor 1/2 of their (2.6) and (2.8).
namespace fde::bench::mechanics {
namespace {

// Gamma^i_jk = 1/2 g^il (dg_lj/dx^k + dg_lk/dx^j - dg_jk/dx^l), in the order (i, j, k).
ExpressionMatrix christoffel_symbols(const Dynamics& dynamics) {
  const auto& algebra = dynamics.algebra();
  const auto& metric = dynamics.metric();
  const auto variables = dynamics.system().q();
  const auto n = variables.size();
  const auto slopes = algebra.jacobian(metric.entries, variables);
  ExpressionMatrix first_kind(n, n * n, algebra.zero());
  for (std::size_t l = 0; l < n; ++l) {
    for (std::size_t j = 0; j < n; ++j) {
      for (std::size_t k = 0; k < n; ++k) {
        const auto both = algebra.sum(slopes(l * n + j, k), slopes(l * n + k, j));
        first_kind(l, j * n + k) =
            algebra.product(algebra.number(0.5), algebra.difference(both, slopes(j * n + k, l)));
      }
    }
  }
  return algebra.solve(metric, first_kind);
}

// The parts of a Geometry as one list of numbers, in the order of its fields.
class GeometryProgram {
 public:
  explicit GeometryProgram(const Dynamics& dynamics) : n_(std::ssize(dynamics.system().coordinates)) {
    const auto& system = dynamics.system();
    const auto& algebra = dynamics.algebra();
    const auto symbols = christoffel_symbols(dynamics);
    Expressions all = dynamics.metric().entries;
    const auto velocity = algebra.variables(system.v());
    append(all, symbols.entries);
    ExpressionMatrix of_one(system.size(), system.size(), algebra.zero());
    for (std::size_t i = 0; i < system.size(); ++i) {
      for (std::size_t j = 0; j < system.size(); ++j)
        for (std::size_t k = 0; k < system.size(); ++k) of_one(j, k) = symbols(i, j * system.size() + k);
      append(all, algebra.product(of_one, velocity));
    }
    append(all, algebra.negative(dynamics.free_acceleration()));
    has_constrained_motion_ = system.memory.empty() && dynamics.has_constraints();
    if (has_constrained_motion_) {
      const auto lambda = dynamics.regular_multiplier();
      multipliers_ = std::ssize(lambda);
      append(all, lambda);
      const auto spray =
          algebra.negative(algebra.sum(dynamics.free_acceleration(), dynamics.reaction(lambda)));
      append(all, spray);
      for (const auto slope : algebra.jacobian(spray, system.v()).entries)
        all.push_back(algebra.product(algebra.number(0.5), slope));
    }
    size_ = std::ssize(all);
    columns_ = static_cast<Eigen::Index>(system.column_count());
    program_ = Program(algebra.pool(), all, columns_);
  }

  [[nodiscard]] Geometry at(In q, In v) const {
    Vec columns = Vec::Zero(columns_), values(size_);
    columns.head(n_) = q;
    columns.segment(n_, n_) = v;
    program_.evaluate(0.0, columns, {values.data(), static_cast<std::size_t>(size_)});
    values.array() += 0.0;  // 0 rather than -0
    Eigen::Index next = 0;
    const auto table = [&] {
      Matrix read(n_, n_);
      for (Eigen::Index i = 0; i < n_; ++i)
        for (Eigen::Index j = 0; j < n_; ++j) read(i, j) = values[next++];
      return read;
    };
    const auto vector = [&](Eigen::Index size) -> Vec {
      return values.segment(std::exchange(next, next + size), size);
    };
    Geometry geometry{.metric = table(),
                      .christoffel = {},
                      .connection = {},
                      .semispray = {},
                      .multipliers = {},
                      .constrained_semispray = {},
                      .constrained_connection = {}};
    for (Eigen::Index i = 0; i < n_; ++i) geometry.christoffel.push_back(table());
    geometry.connection = table();
    geometry.semispray = vector(n_);
    if (!has_constrained_motion_) return geometry;
    geometry.multipliers = vector(multipliers_);
    geometry.constrained_semispray = vector(n_);
    geometry.constrained_connection = table();
    return geometry;
  }

 private:
  static void append(Expressions& all, const Expressions& more) {
    all.insert(all.end(), more.begin(), more.end());
  }

  Eigen::Index n_, columns_ = 0, size_ = 0, multipliers_ = 0;
  bool has_constrained_motion_ = false;
  Program program_{};
};

// f(0, q, v) = 0 by Newton's method, each step of which goes along the reaction.
std::function<Vec(In q, In v)> allowed_velocity(const Dynamics& dynamics) {
  const auto& system = dynamics.system();
  const auto size = static_cast<Eigen::Index>(system.column_count());
  const auto step = dynamics.compensation(dynamics.constraint());
  return [size, program = Program(dynamics.algebra().pool(), step, size)](In q, In v) -> Vec {
    Vec columns = Vec::Zero(size);
    columns.head(q.size()) = q;
    return velocity_on_constraints(v, [&](const Vec& now) -> Vec {
      Vec moved(now.size());
      columns.segment(q.size(), now.size()) = now;
      program(0.0, columns, moved);
      return moved;
    });
  };
}

}  // namespace

StateGeometry geometry_of(const Dynamics& dynamics, const std::vector<std::string>& coordinates) {
  const auto& system = dynamics.system();
  const auto program = std::make_shared<const GeometryProgram>(dynamics);
  StateGeometry geometry{coordinates, system.position, system.velocity,
                         [program](In q, In v) { return program->at(q, v); }};
  if (system.memory.empty() && dynamics.has_constraints()) geometry.allowed = allowed_velocity(dynamics);
  return geometry;
}

}  // namespace fde::bench::mechanics
