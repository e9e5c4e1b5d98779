// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "fdebench/schemes/history/history_kind.hpp"
#include "fdebench/schemes/history/symbols/symbol.hpp"
#include "fdebench/schemes/problem/resolution.hpp"
#include "fdebench/schemes/problem/smoothness.hpp"
#include "fdebench/schemes/stepping/trajectory.hpp"

namespace fde {

class CheckpointStore;

// Settings of a run that are not part of the problem.
struct Options {
  HistoryKind history = HistoryKind::automatic;
  int corrections = 1;  // corrector iterations of predictor-corrector schemes, >= 1
  // The relative error allowed in a step in addition to the discretisation error; default: rounding. It
  // bounds the error of Newton's method in a step (see NewtonSolver) and of every weight of the memory term.
  double newton_tolerance = 1e-15;
  double budget = std::numeric_limits<double>::infinity();  // seconds of run time after which the run ends
  int threads = 1;  // >= 1; may share a step of many unknowns; the result has the same bits for any number
  std::vector<double> output_times{};  // increasing, each up to rounding; empty: all times
  // Whether to search for further solutions of a two-sided problem: Trajectory::other_solutions.
  bool all_solutions = false;
  std::vector<Event> events{};  // only for schemes with an adaptive step size; the others throw
  // Called after every step and at t = 0, whatever `output_times` is.
  std::function<void(double t, In y)> observer{};
  // Called once, before the first step, with y at any time from 0 to the end of the last step, which is valid
  // during the run. A run over a grid interpolates its results and stores them for that. Empty: not wanted.
  std::function<void(const Past& solution)> wants_past{};
  // Where the run stores and resumes its state, for schemes with Capabilities::checkpoints; nullptr: none.
  // The state of the observer is not part of a checkpoint.
  CheckpointStore* checkpoints = nullptr;
};

// How the steps of a run are given: as a grid, or by a tolerance for an adaptive step size.
enum class ResolutionKind { grid, tolerance };

// The capabilities of a scheme: which resolution it takes and which problems it can solve.
struct Capabilities {
  ResolutionKind resolution = ResolutionKind::grid;
  bool discretises_equations = false;  // discretises Problem::equations instead of the rows
  bool uniform_grid = false;           // only uniform grids
  bool implicit = false;               // solves an equation in each step and uses Problem::derivatives
  bool algebraic_rows = false;         // accepts order 0
  double max_order = 2.0;
  bool is_two_sided = false;  // accepts right derivatives and boundary conditions
  bool checkpoints = false;   // supports Options::checkpoints, for problems that it solves by time stepping

  [[nodiscard]] bool is_adaptive() const { return resolution == ResolutionKind::tolerance; }
};

// Where an error is measured: at a fixed time t > 0, at t_1 = h, or as the maximum over all grid times. The
// three rates differ for a solution with a term t^g.
enum class Norm { end, first_step, maximum };

// A proved rate of a scheme at fixed times, with its hypothesis.
struct Theorem {
  std::string_view name, hypothesis, rate;
};

// Runs a scheme with a grid or a tolerance; runs a scheme over a grid.
using Solve = std::function<Trajectory(const Problem&, const Resolution&, const Options&)>;
using GridSolve = std::function<Trajectory(const Problem&, const Grid&, const Options&)>;

// The theoretical rate of a scheme on grids with this grading, in this norm.
using ExpectedRate = std::function<double(const Problem&, const Smoothness&, double grading, Norm norm)>;

// A scheme: its description and the function that runs it; it has no state.
struct Scheme {
  std::string_view id, title, source;
  Capabilities capabilities;
  // The theoretical rate as steps -> infinity on grids with this grading, with default options, for the
  // components that are not algebraic rows; empty: unknown.
  ExpectedRate expected_rate{};
  // Runs the scheme. Precondition: unsupported_reason(...) is empty. Never throws for numerical failure: see
  // Trajectory::status. Of Options::output_times it returns the times that are grid times or that it can
  // interpolate.
  Solve solve{};
  // A reason to refuse a problem that `capabilities` does not express; empty function: none.
  std::function<std::optional<std::string>(const Problem&)> unsupported_problem_reason{};
  // The symbol of the scheme with this step size and one correction. Preconditions: the problem is linear,
  // has no algebraic rows and no right derivatives, and is not refused.
  std::function<Symbol(const Problem&, double length)> symbol{};
  // The id of the scheme whose chains this scheme expands into components of equal order; empty: none.
  std::string_view expansion_of{};
  std::optional<Theorem> theorem{};
  // The powers of t in f for which the starting weights are exact, from the orders of the problem alone;
  // empty: the scheme has no starting weights.
  std::function<std::vector<double>(const Problem&)> starting_powers{};
  std::string_view alias{};  // an alias that find_scheme accepts; empty: none
};

// Scheme::solve from a function that takes a grid. Where the right-hand side jumps at a grid time, the
// function is given the mean of both sides (GridJumps). Precondition of the result: the resolution is a Grid.
Solve on_grid(GridSolve solve);

// Why the scheme cannot solve the problem with this resolution, as part of a sentence; nullopt: it can.
std::optional<std::string> unsupported_reason(const Scheme& scheme, const Problem& problem,
                                              const Resolution& resolution);

// Why the scheme does not support checkpoints for this problem, as part of a sentence; nullopt: it does.
std::optional<std::string> unsupported_checkpoints_reason(const Scheme& scheme, const Problem& problem);

// All schemes, in the order of list.def.
std::span<const Scheme> schemes();

// The scheme with this id or alias; nullptr where there is none. The object has static lifetime.
const Scheme* find_scheme(std::string_view id);

}  // namespace fde
