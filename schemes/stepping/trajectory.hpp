#pragma once

#include <cstdint>
#include <vector>

#include "problem/grid.hpp"
#include "problem/problem.hpp"

namespace fde {

using Rows = Matrix;  // one row a component, one column a time

// How a run ended. A scheme says the first five; who compares the run with its reference says the others.
enum class Ending {
  finished,
  not_finite,
  not_converged,  // Newton's method
  singular,       // left the domain of its problem
  out_of_budget,
  accuracy_lost,       // finished, but see accuracy_lost()
  overflow,            // finished where the solution itself is infinite
  no_reference,        // finished, and there is nothing to compare with
  passed_singularity,  // finished beyond a singularity of the solution
  false_singularity,   // singular, and the solution is not
  refused,             // did not begin
};

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
  Ending ending = Ending::finished;
  int reached = 0;  // the last step with a result; the next one failed unless ending is finished
  Cost cost{};
};

}  // namespace fde
