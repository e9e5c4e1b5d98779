// SPDX-License-Identifier: MIT
// The cost of a step of an equation file, in CPU nanoseconds, beside that of the same problem with right-hand
// side and Jacobian written by hand. Both are solved in turn; a ratio is the median of those of the pairs.
//   fde_step_costs [STEPS [PAIRS]]    65536 steps and 11 pairs without arguments

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <ctime>
#include <stdexcept>
#include <utility>
#include <vector>

#include "fdebench/benchmarks/equation_files/equation_scene.hpp"
#include "fdebench/benchmarks/programs/expressions/systems.hpp"
#include "fdebench/benchmarks/scenes/variant.hpp"
#include "fdebench/benchmarks/text/number_text.hpp"
#include "fdebench/schemes/stepping/scheme.hpp"

namespace {

using namespace fde;
using namespace fde::bench;

struct TimedRun {
  double nanoseconds;  // of CPU time, per step
  Vec end;
};

double processor_nanoseconds() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return 1e9 * static_cast<double>(now.tv_sec) + static_cast<double>(now.tv_nsec);
}

TimedRun timed_run(const Scheme& scheme, const Problem& problem, int steps) {
  const Grid grid{.end = problem.end, .steps = steps};
  const double before = processor_nanoseconds();
  const auto path = scheme.solve(problem, grid, {.output_times = {grid.end}});
  const double after = processor_nanoseconds();
  if (path.status != SolveStatus::finished) throw std::runtime_error("the run did not finish");
  return {(after - before) / steps, path.y.rightCols(1)};
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + std::ssize(values) / 2;
  std::ranges::nth_element(values, middle);
  return *middle;
}

Problem written_by_hand(const WrittenTwice& system, Problem problem) {
  problem.rhs = system.rhs;
  if (system.jacobian) problem.derivatives = DenseJacobian{system.jacobian};
  return problem;
}

void print_row(const WrittenTwice& system, const Scheme& scheme, const Problem& file, int steps, int pairs) {
  const Problem hand = written_by_hand(system, file);
  std::vector<double> of_file, of_hand, ratios;
  double difference = 0.0;
  for (int pair = 0; pair < pairs; ++pair) {
    const bool file_first = pair % 2 == 0;
    auto first = timed_run(scheme, file_first ? file : hand, steps);
    auto second = timed_run(scheme, file_first ? hand : file, steps);
    difference = std::max(difference, (first.end - second.end).cwiseAbs().maxCoeff());
    if (!file_first) std::swap(first, second);
    of_file.push_back(first.nanoseconds);
    of_hand.push_back(second.nanoseconds);
    ratios.push_back(first.nanoseconds / second.nanoseconds);
  }
  fmt::print("{:15} {:22} {:8.1f} {:8.1f} {:6.2f}   {:.0e}\n", system.name, scheme.id, median(of_file),
             median(of_hand), median(ratios), difference);
  std::fflush(stdout);
}

}  // namespace

int main(int count, char** arguments) {
  try {
    const int steps = count > 1 ? parse_count("STEPS", arguments[1], 1, 1 << 24) : 1 << 16;
    const int pairs = count > 2 ? parse_count("PAIRS", arguments[2], 1, 1000) : 11;
    fmt::print("{:15} {:22} {:>8} {:>8} {:>6}   {}\n", "system", "scheme", "file", "by hand", "ratio",
               "difference at the end");
    for (const auto& system : systems_written_twice()) {
      const auto factory = equation_scene(parse_equation_text("system.toml", system.file));
      const Scene scene = make_scene(factory);
      for (const auto* id : {"adams_pc", "product_trapezoidal", "bdf2", "decoupled_multi_order"})
        print_row(system, *find_scheme(id), scene.problem, steps, pairs);
    }
  } catch (const std::exception& error) {
    fmt::print(stderr, "fde_step_costs: {}\n", error.what());
    return 2;
  }
  return 0;
}
