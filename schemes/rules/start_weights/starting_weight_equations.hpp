// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <vector>

#include "fdebench/schemes/rules/start_weights/start_weights.hpp"

namespace fde {

// Solves the equations of the starting weights: in double-doubles, or in 70 digits where the powers are so
// close to each other that 31 digits are too few.
class StartingWeightEquations {
 public:
  StartingWeightEquations() = default;
  virtual ~StartingWeightEquations() = default;
  StartingWeightEquations& operator=(StartingWeightEquations&&) = delete;

  // W(n, j) for n = 1 ... K, one row a step, one column a j, from the defining sums. From K on the asymptotic
  // expansions are accurate to rounding: the contributions of all other singularities of the generating
  // function have decayed.
  [[nodiscard]] virtual Matrix tabulated_weights() const = 0;

  // W on [K 2^piece, K 2^(piece+1)], by the expansions at the singularities of the generating function.
  // Thread-safe.
  [[nodiscard]] virtual StartingWeights::ChebyshevPiece asymptotic_weights(std::size_t piece) const = 0;
};

// Precondition: table.family->multistep is set.
std::shared_ptr<const StartingWeightEquations> starting_weight_equations(const WeightTable& table,
                                                                         const std::vector<double>& powers);

// As usable_powers, with the bound `most` of the growth.
UsablePowers count_usable(const WeightTable& table, const std::vector<double>& powers, double most);

}  // namespace fde
