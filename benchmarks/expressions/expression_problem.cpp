// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/expressions/expression_problem.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <span>
#include <utility>

#include "fdebench/benchmarks/expressions/instructions.hpp"
#include "fdebench/benchmarks/expressions/program.hpp"
#include "fdebench/benchmarks/expressions/values_at_start.hpp"

namespace fde::bench {
namespace {

struct Entry {
  Eigen::Index row, column;
  Expression value;
};

// The nonzero entries of df_i/dy_j, row by row. Throws DerivativeError for a row that has no derivative.
std::vector<Entry> derivatives_of(const std::vector<Expression>& rows, ExpressionPool& pool) {
  std::vector<Entry> entries;
  const auto zero = pool.number(0);
  for (Eigen::Index row = 0; row < std::ssize(rows); ++row) {
    const auto of = rows[static_cast<std::size_t>(row)];
    for (const int variable : pool.variables_in(of)) {
      if (variable < 1 || variable > std::ssize(rows)) continue;  // t, or an earlier value
      try {
        const auto value = pool.derivative(of, variable);
        if (value != zero) entries.push_back({row, variable - 1, value});
      } catch (const std::invalid_argument& none) {
        throw DerivativeError(row, none.what());
      }
    }
  }
  return entries;
}

// Expressions of unknowns with the sign of which a row jumps.
std::vector<Expression> switches_of(const std::vector<Expression>& rows, ExpressionPool& pool) {
  std::vector<Expression> found;
  for (const auto one : pool.switches(rows, jumps))
    if (pool.depends_on_unknowns(one)) found.push_back(one);
  return found;
}

// Whether a row has a kink or a jump in the unknowns; its derivative may be constant elsewhere.
bool piecewise(const std::vector<Expression>& rows, const ExpressionPool& pool) {
  const auto arguments =
      pool.arguments(rows, [](const ExpressionPool::Node& node) { return jumps(node) || has_kink(node); });
  return std::ranges::any_of(arguments, [&](Expression e) { return pool.depends_on_unknowns(e); });
}

// The value of an expression if it is constant, either as written or because its derivatives vanish: (y +
// 1)^2 - y^2 has a constant derivative.
std::optional<double> constant_of(Expression value, Eigen::Index variables, ExpressionPool& pool) {
  constexpr Eigen::Index few = 12;
  if (const auto known = pool.value(value)) return static_cast<double>(*known);
  const auto zero = pool.number(0);
  // sign, step and floor have derivative 0 but are not constant
  const bool may_jump = !pool.arguments({value}, jumps).empty();
  if (variables > few || may_jump) return std::nullopt;
  for (int variable = 0; variable <= variables; ++variable) {
    const auto slope = pool.derivative(value, variable);
    if (slope != zero && pool.value(slope) != 0.0L) return std::nullopt;
  }
  const auto at_zero = pool.value(pool.without_variables(value, 0));
  if (!at_zero || !std::isfinite(static_cast<double>(*at_zero))) return std::nullopt;
  return static_cast<double>(*at_zero);
}

// The constant values of the entries; nullopt if one varies. variables: the number of those beside t.
std::optional<std::vector<double>> constants_of(const std::vector<Entry>& entries, Eigen::Index variables,
                                                ExpressionPool& pool) {
  std::vector<double> values;
  for (const auto& entry : entries) {
    const auto known = constant_of(entry.value, variables, pool);
    if (!known || !std::isfinite(*known)) return std::nullopt;
    values.push_back(*known);
  }
  return values;
}

Matrix matrix_of(const std::vector<Entry>& entries, const std::vector<double>& values, Eigen::Index size) {
  Matrix matrix = Matrix::Zero(size, size);
  for (std::size_t k = 0; k < entries.size(); ++k) matrix(entries[k].row, entries[k].column) = values[k];
  return matrix;
}

SparseMatrix sparse_matrix_of(const std::vector<Entry>& entries, const std::vector<double>& values,
                              Eigen::Index size) {
  std::vector<Eigen::Triplet<double>> triplets;
  for (std::size_t k = 0; k < entries.size(); ++k)
    triplets.emplace_back(entries[k].row, entries[k].column, values[k]);
  SparseMatrix matrix(size, size);
  matrix.setFromTriplets(triplets.begin(), triplets.end());
  return matrix;
}

// Whether a sparse matrix is worth while: of many rows that depend on few others, as those of a field.
bool is_sparse(const std::vector<Entry>& entries, const std::vector<Component>& components) {
  constexpr std::size_t fewest_rows = 101, fewest_zeros = 8;
  const auto size = components.size();
  return size >= fewest_rows && entries.size() <= size * size / fewest_zeros &&
         std::ranges::none_of(components, is_algebraic);
}

// A program writes the values of the sparse matrix in their order, by columns.
SparseJacobian sparse_jacobian_of(const std::vector<Entry>& entries, Eigen::Index size,
                                  const ExpressionPool& pool) {
  auto pattern =
      std::make_shared<SparseMatrix>(sparse_matrix_of(entries, std::vector(entries.size(), 1.0), size));
  std::vector<Entry> by_column = entries;
  std::ranges::stable_sort(by_column, {}, &Entry::column);
  std::vector<Expression> values;
  for (const auto& entry : by_column) values.push_back(entry.value);
  return {[pattern, count = values.size(), program = Program(pool, values, size)](double t, In y,
                                                                                  SparseMatrix& jacobian) {
    jacobian = *pattern;
    program.evaluate(t, y, {jacobian.valuePtr(), count});
  }};
}

// Writes to the places of a matrix without gaps between its columns.
Program entries_program(const std::vector<Entry>& entries, Eigen::Index size, const ExpressionPool& pool) {
  std::vector<Expression> values;
  std::vector<Eigen::Index> places;
  for (const auto& [row, column, value] : entries) {
    values.push_back(value);
    places.push_back(column * size + row);
  }
  return {pool, values, places, size};
}

DenseJacobian jacobian_of(const std::vector<Entry>& entries, Eigen::Index size, const Program& program) {
  const auto count = static_cast<std::size_t>(size * size);
  return {[size, count, has_zeros = entries.size() < count, program](double t, In y, OutMatrix jacobian) {
    if (jacobian.outerStride() != size) {
      Matrix matrix = Matrix::Zero(size, size);
      program.evaluate(t, y, {matrix.data(), count});
      jacobian = matrix;
      return;
    }
    if (has_zeros) std::fill_n(jacobian.data(), count, 0.0);
    program.evaluate(t, y, {jacobian.data(), count});
  }};
}

ProblemText text_of(const Program& rhs, const Matrix& jacobian) {
  ProblemText text{.rhs = rhs.texts()};
  for (const auto& row : jacobian.rowwise()) {
    auto& texts = text.jacobian.emplace_back();
    for (const double value : row) texts.push_back(formula_number(value));
  }
  return text.rhs.empty() ? ProblemText{} : text;
}

ProblemText text_of(const Program& rhs, const std::vector<Entry>& entries, const Program& jacobian) {
  ProblemText text{.rhs = rhs.texts()};
  const auto values = jacobian.texts();
  if (text.rhs.empty() || values.size() < entries.size()) return {};
  text.jacobian.assign(text.rhs.size(), std::vector<std::string>(text.rhs.size(), formula_number(0.0)));
  for (std::size_t k = 0; k < entries.size(); ++k) {
    const auto row = static_cast<std::size_t>(entries[k].row);
    text.jacobian[row][static_cast<std::size_t>(entries[k].column)] = values[k];
  }
  return text;
}

// Where a derivative is infinite at the initial values, y says too little of f next to t = 0.
IncrementForm increments_of(const Problem& problem, const std::vector<Expression>& rows,
                            ExpressionPool& pool) {
  Vec origin = taylor_part(problem, 0.0);
  Matrix jacobian(problem.size(), problem.size());
  evaluate_jacobian(problem, 0.0, origin, jacobian);
  if (jacobian.allFinite() || is_two_sided(problem) || unknown_count(problem) > 0) return {};
  origin(algebraic_rows(problem)).setZero();
  const auto shifted = in_increments(rows, origin, pool);
  if (!shifted) return {};
  const auto size = problem.size();
  const auto entries = derivatives_of(*shifted, pool);
  return {std::move(origin), Program(pool, *shifted, size),
          jacobian_of(entries, size, entries_program(entries, size, pool)).at};
}

// The state and the earlier values, the variables of right-hand sides with delays.
class VariablesOfDelays {
 public:
  VariablesOfDelays(const EarlierValues& earlier, Eigen::Index size)
      : lags_(lags_of(earlier.values)), values_(earlier.values), size_(size) {}

  [[nodiscard]] const std::vector<double>& lags() const { return lags_; }

  [[nodiscard]] Vec at(double t, In y, const Past& past) const {
    Vec all(size_ + std::ssize(values_)), earlier(size_);
    all.head(size_) = y;
    for (const double lag : lags_) {
      past(t - lag, earlier);
      for (std::size_t k = 0; k < values_.size(); ++k)
        if (values_[k].lag == lag) all[size_ + static_cast<Eigen::Index>(k)] = earlier[values_[k].row];
    }
    return all;
  }

 private:
  static std::vector<double> lags_of(const std::vector<EarlierValue>& values) {
    std::vector<double> lags;
    for (const auto& value : values) lags.push_back(value.lag);
    return increasing(std::move(lags));
  }

  std::vector<double> lags_;
  std::vector<EarlierValue> values_;
  Eigen::Index size_;
};

Problem delayed_problem(std::vector<Component> components, const std::vector<Expression>& rows, double end,
                        ExpressionPool& pool, const EarlierValues& earlier) {
  const auto size = std::ssize(rows), variables = size + std::ssize(earlier.values);
  Problem problem{.components = std::move(components), .end = end};
  for (const auto value : switches_of(rows, pool))
    problem.switching_functions.emplace_back(Program(pool, {value}, size));
  const VariablesOfDelays all(earlier, size);
  problem.delays = {
      .lags = all.lags(),
      .before = [program = Program(pool, earlier.before, 0)](double t, Out y) { program(t, Vec(), y); },
      .rhs = [all, program = Program(pool, rows, variables)](double t, In y, const Past& past,
                                                             Out f) { program(t, all.at(t, y, past), f); }};
  const auto entries = derivatives_of(rows, pool);
  const auto constants = piecewise(rows, pool) ? std::nullopt : constants_of(entries, variables, pool);
  if (constants) {
    problem.derivatives = DenseLinearPart{matrix_of(entries, *constants, size)};
  } else {
    problem.delays.jacobian = [all, of = jacobian_of(entries, size, entries_program(entries, size, pool))](
                                  double t, In y, const Past& past, OutMatrix jacobian) {
      of.at(t, all.at(t, y, past), jacobian);
    };
  }
  return problem;
}

}  // namespace

Problem expression_problem(std::vector<Component> components, const std::vector<Expression>& as_given,
                           double end, ExpressionPool& pool, const EarlierValues& earlier) {
  const auto rows = with_limits_at_start(as_given, pool);
  const auto size = std::ssize(rows);
  if (!earlier.values.empty()) return delayed_problem(std::move(components), rows, end, pool, earlier);
  Problem problem{.components = std::move(components), .end = end};
  const Program rhs(pool, rows, size);
  problem.rhs = rhs;
  problem.range = [rhs](const Interval& t, std::span<const Interval> y, std::span<Interval> f) {
    rhs.enclose(t, y, f);
  };
  for (const auto value : switches_of(rows, pool))
    problem.switching_functions.emplace_back(Program(pool, {value}, size));
  const auto entries = derivatives_of(rows, pool);
  const auto constants = piecewise(rows, pool) ? std::nullopt : constants_of(entries, size, pool);
  const bool sparse = is_sparse(entries, problem.components);
  if (sparse && constants) {
    problem.derivatives = SparseLinearPart{sparse_matrix_of(entries, *constants, size)};
  } else if (sparse) {
    problem.derivatives = sparse_jacobian_of(entries, size, pool);
  } else if (constants) {
    auto matrix = matrix_of(entries, *constants, size);
    problem.text = [rhs, matrix] { return text_of(rhs, matrix); };
    problem.derivatives = DenseLinearPart{std::move(matrix)};
  } else {
    const auto program = entries_program(entries, size, pool);
    problem.text = [rhs, entries, program] { return text_of(rhs, entries, program); };
    problem.derivatives = jacobian_of(entries, size, program);
    problem.increments = increments_of(problem, rows, pool);
  }
  return problem;
}

}  // namespace fde::bench
