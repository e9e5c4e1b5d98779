// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <vector>

#include "fdebench/schemes/rules/start_weights/start_weights.hpp"

namespace fde {

// Solves the equations of the starting weights in multiprecision (number_series.hpp). This header does not
// include the multiprecision headers.
class StartingWeightEquations {
 public:
  // asymptotic_weights evaluates at these points, 1 <= point <= 2. Precondition: table.family->multistep is
  // set.
  StartingWeightEquations(const WeightTable& table, const std::vector<double>& powers,
                          const std::vector<double>& points);
  ~StartingWeightEquations();
  StartingWeightEquations(const StartingWeightEquations&) = delete;
  StartingWeightEquations& operator=(const StartingWeightEquations&) = delete;
  StartingWeightEquations(StartingWeightEquations&&) = delete;
  StartingWeightEquations& operator=(StartingWeightEquations&&) = delete;

  // W(n, j) for n = 1 ... K, one row a step, one column a j, from the defining sums. From K on the asymptotic
  // expansions are accurate to rounding: the contributions of all other singularities of the generating
  // function have decayed.
  [[nodiscard]] Matrix tabulated_weights() const;

  // W(x, j) at x = K 2^piece point, one row a point, one column a j, by the expansions at zeta = 1 and at -1,
  // which extend W to real x.
  [[nodiscard]] StartingWeights::ChebyshevPiece asymptotic_weights(std::size_t piece) const;

  // As usable_powers, with the bound `most` of the growth.
  static UsablePowers usable(const WeightTable& table, const std::vector<double>& powers, double most);

 private:
  struct Numbers;
  struct Expansions;
  struct PowersAt;
  std::unique_ptr<Numbers> numbers_;
  std::unique_ptr<Expansions> expansions_;
  std::vector<PowersAt> points_;
};

}  // namespace fde
