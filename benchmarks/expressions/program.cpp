// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/expressions/program.hpp"

#include <algorithm>
#include <array>
#include <cstddef>

#include "fdebench/benchmarks/expressions/apply.hpp"

namespace fde::bench {

// Slots: inputs, numbers, then one per line.
Program::Program(const ExpressionPool& pool, const std::vector<Expression>& results, Eigen::Index size)
    : inputs_(static_cast<int>(size) + 1) {
  if (results.empty()) return;
  const auto used = pool.subexpressions(results);
  std::vector<int> places(used.size(), 0);
  for (std::size_t e = 0; e < used.size(); ++e) {
    const auto& entry = pool[static_cast<Expression>(e)];
    if (!used[e] || entry.operation != Operation::number) continue;
    places[e] = inputs_ + static_cast<int>(numbers_.size());
    numbers_.push_back(static_cast<double>(entry.value));
  }
  const int first = inputs_ + static_cast<int>(numbers_.size());
  for (std::size_t e = 0; e < used.size(); ++e) {
    const auto& entry = pool[static_cast<Expression>(e)];
    if (!used[e] || entry.operation == Operation::number) continue;
    if (entry.operation == Operation::variable) {
      places[e] = entry.variable;
      continue;
    }
    places[e] = first + static_cast<int>(lines_.size());
    const auto place = [&](std::size_t i) {
      return entry.arguments[i] == ExpressionPool::none
                 ? 0
                 : places[static_cast<std::size_t>(entry.arguments[i])];
    };
    lines_.push_back({entry.operation, place(0), place(1), place(2)});
  }
  for (const auto result : results) results_.push_back(places[static_cast<std::size_t>(result)]);
}

void Program::evaluate(double t, In y, std::span<double> results) const {
  constexpr std::size_t usual = 256;
  const auto size = static_cast<std::size_t>(inputs_) + numbers_.size() + lines_.size();
  std::array<double, usual>
      few;  // NOLINT(cppcoreguidelines-pro-type-member-init): all that is read is written
  std::vector<double> many(size > usual ? size : 0);
  double* const values = many.empty() ? few.data() : many.data();
  values[0] = t;
  std::copy_n(y.data(), inputs_ - 1, values + 1);
  double* next = std::ranges::copy(numbers_, values + inputs_).out;
  for (const auto& [operation, a, b, c] : lines_)
    *next++ = apply<double>(operation, values[a], values[b], values[c]);
  for (std::size_t i = 0; i < results.size(); ++i) results[i] = values[results_[i]];
}

double Program::operator()(double t, In y) const {
  double result = 0.0;
  evaluate(t, y, {&result, 1});
  return result;
}

}  // namespace fde::bench
