#pragma once

#include <cstdint>
#include <vector>

#include "grid.hpp"
#include "problem.hpp"

namespace fde {

using Rows = Matrix;  // one row a component, one column a time

// How a run ended. Singular: it left the domain of its problem.
enum class Outcome { finished, not_finite, not_converged, singular, out_of_budget };

// What a run used, apart from time.
struct Cost {
  std::int64_t rhs_calls = 0;
  std::int64_t newton_iterations = 0;
  std::size_t history_bytes = 0;
  int states = 0;  // components actually stepped; more than the problem's where a scheme splits orders
};

// What a scheme returns: y at the steps that were asked for, as far as the run came.
struct Trajectory {
  Grid grid{};
  std::vector<int> steps{};  // y.col(c) belongs to grid.time(steps[c])
  Rows y{};
  Outcome outcome = Outcome::finished;
  int reached = 0;  // the last step with a result; the next one failed unless outcome is finished
  Cost cost{};
};

}  // namespace fde
