// SPDX-License-Identifier: MIT
#include "fdebench/reference/linear/linear_system.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "fdebench/reference/linear/linear_solution.hpp"
#include "fdebench/reference/linear/transfer_functions/characteristic_zeros.hpp"
#include "fdebench/reference/linear/transfer_functions/generalized_polynomial.hpp"
#include "fdebench/reference/linear/transfer_functions/linear_transform.hpp"

namespace fde::reference {

namespace {

// The matrix diag(s^g) - A of (diag(s^g) - A) X = R, R_j = sum_k s^(g_j-1-k) x_j^(k)(0) + sum of loads c
// Gamma(power+1) s^(-power-1). By Cramer's rule X_i = N_i / P, where P is the determinant and N_i the
// determinant with R in column i.
PolynomialMatrix matrix_of(const ExactLinearSystem& system) {
  const std::size_t size = system.orders.size();
  PolynomialMatrix matrix(size, std::vector<GeneralizedPolynomial>(size));
  for (std::size_t i = 0; i < size; ++i) {
    add_term(matrix[i][i], system.orders[i], Rational(1));
    for (std::size_t j = 0; j < size; ++j) add_term(matrix[i][j], 0, Rational(-system.matrix[i][j]));
  }
  return matrix;
}

// R for each time at which a load starts, 0 first.
struct RightSide {
  Rational from;
  std::vector<GeneralizedPolynomial> rows;
};

std::vector<RightSide> right_sides(const ExactLinearSystem& system) {
  const std::size_t size = system.orders.size();
  std::vector<RightSide> sides{{0, std::vector<GeneralizedPolynomial>(size)}};
  for (std::size_t j = 0; j < size; ++j) {
    for (std::size_t k = 0; k < system.initial[j].size(); ++k)
      add_term(sides.front().rows[j], Rational(system.orders[j] - 1 - k), system.initial[j][k]);
    for (const auto& [coefficient, power, from, over_gamma] : system.loads[j]) {
      const Rational next = power + 1;
      auto side = std::ranges::find(sides, from, &RightSide::from);
      if (side == sides.end()) side = sides.insert(side, {from, std::vector<GeneralizedPolynomial>(size)});
      add_term(side->rows[j], Rational(-next), coefficient_of_gamma(over_gamma ? Rational(1) : next),
               coefficient);
    }
  }
  return sides;
}

// The Laplace transforms of the outputs, by Cramer's rule with exact determinants. Precondition: the system
// has the form of linear_system.hpp, with one list of loads per row and explicit outputs.
LinearTransform transform_of(const ExactLinearSystem& system) {
  const PolynomialMatrix matrix = matrix_of(system);
  LinearTransform transform;
  transform.generators = system.orders;
  transform.characteristic = determinant(matrix);
  for (const auto& [from, rows] : right_sides(system)) {
    auto& numerators = transform.group_at(from, system.outputs.size()).numerators;
    for (std::size_t k = 0; k < system.outputs.size(); ++k) {
      PolynomialMatrix replaced = matrix;
      for (std::size_t j = 0; j < rows.size(); ++j) replaced[j][system.outputs[k]] = rows[j];
      numerators[k] = determinant(replaced);
    }
  }
  return transform;
}

// Whether the determinant of the transformed system is nonzero: whether the solution is unique.
bool is_regular(const ExactLinearSystem& system) { return !determinant(matrix_of(system)).empty(); }

constexpr const char* name = "linear system";
constexpr std::size_t most_components = 12;  // the determinant has up to 2^components terms

void require(bool holds, const char* message) {
  if (!holds) throw std::invalid_argument(fmt::format("{}: {}", name, message));
}

void require_outputs(const std::vector<std::size_t>& outputs, std::size_t size) {
  for (const std::size_t output : outputs) {
    if (output < size) continue;
    throw std::invalid_argument(fmt::format("{}: output {}: must be 0 to {}", name, output, size - 1));
  }
}

void require_size(std::size_t size) {
  if (size >= 1 && size <= most_components) return;
  throw std::invalid_argument(fmt::format("{}: {} components: must be 1 to {}", name, size, most_components));
}

void require_lists(const auto& system) {
  const std::size_t size = system.orders.size();
  require(system.initial.size() == size, "a list of initial values is needed for each order");
  require(system.loads.empty() || system.loads.size() == size,
          "there have to be no loads, or a list of them for each order");
}

// The shape and the numbers of a system of doubles.
void require_finite(const LinearSystem& system) {
  const std::size_t size = system.orders.size();
  const auto rows = static_cast<Eigen::Index>(size);
  require_size(size);
  require(system.matrix.rows() == rows && system.matrix.cols() == rows,
          "the matrix has to have a row and a column for each order");
  require(system.matrix.allFinite(), "coefficients have to be finite");
  require_lists(system);
  for (std::size_t i = 0; i < size; ++i) {
    require(system.orders[i] >= 0.0 && std::isfinite(system.orders[i]), "orders have to be 0 or above");
    require(std::ranges::all_of(system.initial[i], [](double value) { return std::isfinite(value); }),
            "initial values have to be finite");
    for (const auto& load : system.loads.empty() ? std::vector<Load>{} : system.loads[i])
      require(!validation_error(load), validation_error(load).value_or(""));
  }
}

ExactLinearSystem exact(const LinearSystem& system) {
  const auto fractions = [](const auto& numbers) {
    std::vector<Rational> same;
    for (const double x : numbers) same.push_back(shortest_decimal(x));
    return same;
  };
  ExactLinearSystem same{.orders = fractions(system.orders), .outputs = system.outputs};
  for (const auto& initial : system.initial) same.initial.push_back(fractions(initial));
  for (const auto& row : system.matrix.rowwise()) same.matrix.push_back(fractions(row));
  for (const auto& loads : system.loads) {
    auto& of_row = same.loads.emplace_back();
    for (const Load& load : loads) of_row.push_back(exact(load));
  }
  return same;
}

ExactLinearSystem checked(ExactLinearSystem system) {
  const std::size_t size = system.orders.size();
  require_size(size);
  require_lists(system);
  if (system.loads.empty()) system.loads.resize(size);
  for (std::size_t i = 0; i < size; ++i) {
    const auto count = static_cast<std::size_t>(ceiling(system.orders[i]));
    require(system.initial[i].size() >= count, "an initial value is missing");
    system.initial[i].resize(count);
  }
  require_outputs(system.outputs, size);
  if (system.outputs.empty())
    for (std::size_t i = 0; i < size; ++i) system.outputs.push_back(i);
  require(std::ranges::find(system.orders, Rational(0)) == system.orders.end() || is_regular(system),
          "the rows of order 0 do not determine every unknown");
  return system;
}

// For each component the set of the components that it depends on, itself included, as bits.
std::vector<unsigned> dependencies(const std::vector<std::vector<Rational>>& matrix) {
  const std::size_t size = matrix.size();
  std::vector<unsigned> on(size);
  for (std::size_t i = 0; i < size; ++i) {
    on[i] = 1U << i;
    for (std::size_t j = 0; j < size; ++j)
      if (matrix[i][j] != 0) on[i] |= 1U << j;
  }
  for (std::size_t through = 0; through < size; ++through) {
    for (auto& set : on)
      if ((set >> through & 1U) != 0U) set |= on[through];
  }
  return on;
}

// Outputs whose components depend on the same set of components, and their evaluation.
struct Subsystem {
  std::vector<std::size_t> places;  // indices of the outputs
  Evaluation evaluation;
};

// The part of the outputs that depend on exactly the components of `set`, whose rows have no other unknowns.
// The determinant of the system is the product of the determinants of the parts, so none of them is singular.
Subsystem subsystem_for(const ExactLinearSystem& system, unsigned set, const std::vector<unsigned>& on) {
  std::vector<std::size_t> kept, places;
  for (std::size_t i = 0; i < on.size(); ++i)
    if ((set >> i & 1U) != 0U) kept.push_back(i);
  ExactLinearSystem part;
  for (const std::size_t i : kept) {
    auto& row = part.matrix.emplace_back();
    for (const std::size_t j : kept) row.push_back(system.matrix[i][j]);
    part.orders.push_back(system.orders[i]);
    part.initial.push_back(system.initial[i]);
    part.loads.push_back(system.loads[i]);
  }
  for (std::size_t place = 0; place < system.outputs.size(); ++place) {
    const std::size_t i = system.outputs[place];
    if (on[i] != set) continue;
    places.push_back(place);
    part.outputs.push_back(static_cast<std::size_t>(std::ranges::find(kept, i) - kept.begin()));
  }
  return {places, linear_evaluation(name, [part = std::move(part)] { return transform_of(part); })};
}

// Components that do not depend on others are solved without them; otherwise growing modes of the others
// would have to cancel.
std::vector<Subsystem> subsystems(const ExactLinearSystem& system) {
  const auto on = dependencies(system.matrix);
  std::vector<unsigned> sets;
  for (const std::size_t i : system.outputs)
    if (std::ranges::find(sets, on[i]) == sets.end()) sets.push_back(on[i]);
  std::vector<Subsystem> parts;
  for (const unsigned set : sets) parts.push_back(subsystem_for(system, set, on));
  return parts;
}

// The columns of all parts, in the order of the outputs.
template <class Column, class Evaluate>
std::vector<Column> gathered(const std::vector<Subsystem>& parts, std::size_t size,
                             const Evaluate& evaluate) {
  std::vector<Column> columns(size);
  for (const auto& [places, evaluation] : parts) {
    const std::vector<Column> some = evaluate(evaluation);
    for (std::size_t k = 0; k < places.size(); ++k) columns[places[k]] = some[k];
  }
  return columns;
}

}  // namespace

Reference linear_reference(const LinearSystem& system) {
  require_finite(system);
  return exact_linear_reference(exact(system));
}

Reference exact_linear_reference(const ExactLinearSystem& system) {
  const ExactLinearSystem posed = checked(system);
  const auto parts = subsystems(posed);
  const std::size_t size = posed.outputs.size();
  const auto quick = [parts, size](double t) {
    return gathered<BoundedDouble>(parts, size,
                                   [t](const Evaluation& part) { return evaluate_in_double(part, t); });
  };
  const auto precise = [parts, size](double t, int digits) {
    return gathered<Bounded<BigReal>>(
        parts, size, [t, digits](const Evaluation& part) { return part.precise(t, digits); });
  };
  Reference reference = linear_reference(Evaluation{.name = name, .quick = quick, .precise = precise});
  reference.zeros = [posed] {
    return characteristic_zeros(
        {.characteristic = determinant(matrix_of(posed)), .groups = {}, .generators = posed.orders});
  };
  return reference;
}

}  // namespace fde::reference
