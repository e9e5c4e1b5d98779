// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/expressions/program.hpp"

#include <numeric>

#include "fdebench/benchmarks/expressions/instructions.hpp"

namespace fde::bench {
namespace {

std::vector<Eigen::Index> in_order(std::size_t count) {
  std::vector<Eigen::Index> places(count);
  std::iota(places.begin(), places.end(), Eigen::Index{0});
  return places;
}

}  // namespace

Program::Program(const ExpressionPool& pool, const std::vector<Expression>& results, Eigen::Index size)
    : Program(pool, results, in_order(results.size()), size) {}

Program::Program(const ExpressionPool& pool, const std::vector<Expression>& results,
                 const std::vector<Eigen::Index>& places, Eigen::Index size)
    : shared_(results.empty() ? nullptr
                              : std::make_shared<Shared>(instructions_of(pool, results, places, size))) {}

std::vector<std::string> Program::texts() const {
  return shared_ ? texts_of(shared_->list) : std::vector<std::string>{};
}

// One thread counts to the limit and translates; the others interpret meanwhile.
void Program::Shared::interpret_or_translate(double t, const double* y, std::span<double> results) {
  const int interpreted = interpreted_evaluations(list.instructions.size());
  if (evaluations.load(std::memory_order_relaxed) < interpreted &&
      evaluations.fetch_add(1, std::memory_order_relaxed) + 1 == interpreted) {
    code = machine_code(list);
    function.store(code.get(), std::memory_order_release);
  }
  interpret(list, t, y, results);
}

}  // namespace fde::bench
