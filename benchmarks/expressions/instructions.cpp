// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/expressions/instructions.hpp"

#include <algorithm>
#include <array>

#include "fdebench/benchmarks/expressions/apply.hpp"

namespace fde::bench {

InstructionList instructions_of(const ExpressionPool& pool, const std::vector<Expression>& results,
                                const std::vector<Eigen::Index>& places, Eigen::Index size) {
  InstructionList list{.inputs = static_cast<int>(size) + 1, .places = places};
  const auto used = pool.subexpressions(results);
  std::vector<int> slots(used.size(), 0);
  for (std::size_t e = 0; e < used.size(); ++e) {
    const auto& entry = pool[static_cast<Expression>(e)];
    if (!used[e] || entry.operation != Operation::number) continue;
    slots[e] = list.first();
    list.numbers.push_back(static_cast<double>(entry.value));
  }
  for (std::size_t e = 0; e < used.size(); ++e) {
    const auto& entry = pool[static_cast<Expression>(e)];
    if (!used[e] || entry.operation == Operation::number) continue;
    if (entry.operation == Operation::variable) {
      slots[e] = entry.variable;
      continue;
    }
    slots[e] = static_cast<int>(list.slots());
    const auto slot = [&](std::size_t i) {
      return entry.arguments[i] == ExpressionPool::none ? 0
                                                        : slots[static_cast<std::size_t>(entry.arguments[i])];
    };
    list.instructions.push_back({entry.operation, slot(0), slot(1), slot(2)});
  }
  for (const auto result : results) list.results.push_back(slots[static_cast<std::size_t>(result)]);
  return list;
}

void interpret(const InstructionList& list, double t, const double* y, std::span<double> results) {
  constexpr std::size_t usual = 256;
  std::array<double, usual>
      few;  // NOLINT(cppcoreguidelines-pro-type-member-init): all that is read is written
  std::vector<double> many(list.slots() > usual ? list.slots() : 0);
  double* const values = many.empty() ? few.data() : many.data();
  values[0] = t;
  std::copy_n(y, list.inputs - 1, values + 1);
  double* next = std::ranges::copy(list.numbers, values + list.inputs).out;
  for (const auto& [operation, a, b, c] : list.instructions)
    *next++ = apply<double>(operation, values[a], values[b], values[c]);
  for (std::size_t i = 0; i < list.results.size(); ++i)
    results[static_cast<std::size_t>(list.places[i])] = values[list.results[i]];
}

void interpret(const InstructionList& list, const Interval& t, const Interval* y,
               std::span<Interval> results) {
  std::vector<Interval> values(list.slots());
  values[0] = t;
  std::copy_n(y, list.inputs - 1, values.begin() + 1);
  auto next = std::ranges::copy(list.numbers, values.begin() + list.inputs).out;
  for (const auto& [operation, a, b, c] : list.instructions) {
    const auto at = [&](int slot) { return values[static_cast<std::size_t>(slot)]; };
    // Both factors are the same number: x x has no negative values.
    *next++ = operation == Operation::multiply && a == b ? square(at(a))
                                                         : apply<Interval>(operation, at(a), at(b), at(c));
  }
  for (std::size_t i = 0; i < list.results.size(); ++i)
    results[static_cast<std::size_t>(list.places[i])] = values[static_cast<std::size_t>(list.results[i])];
}

}  // namespace fde::bench
