#pragma once

#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "history/history.hpp"
#include "problem/resolution.hpp"
#include "problem/smoothness.hpp"
#include "stepping/trajectory.hpp"
#include "symbols/symbol.hpp"

namespace fde {

class Checkpoints;

// Settings of a run that are not part of the problem.
struct Options {
  HistoryKind history = HistoryKind::automatic;
  int corrections = 1;  // corrector iterations of predictor-corrector schemes, >= 1
  // What a step may be off by besides the rule's own error, relative; default: rounding. It bounds what
  // Newton's method leaves of a step (see NewtonSolver), and the error of every weight of the past.
  double tolerance = 1e-15;
  double budget = std::numeric_limits<double>::infinity();  // seconds: a run that takes longer ends there
  int threads = 1;  // among which a step of many unknowns may be shared; the result has the same bits for any
  std::vector<double> at{};     // times to return, increasing, each up to rounding; empty: all
  bool all_solutions = false;   // of a problem at both ends: see Trajectory::others
  std::vector<Event> events{};  // located by schemes that choose their steps; others refuse to run with them
  std::function<void(double t, In y)> observer{};  // hears every step from t = 0 on, returned or not
  // Where the run keeps its state and goes on from it, where Needs::checkpoints is; nullptr: nowhere. What an
  // observer has heard is not part of the state.
  Checkpoints* checkpoints = nullptr;
};

// What a scheme takes, and what it asks of a problem.
struct Needs {
  bool takes_grid = true;
  bool takes_accuracy = false;
  bool discretises_equations = false;  // Problem::equations, in place of its rows
  bool uniform_grid = false;
  bool implicit = false;        // solves an equation each step: uses the derivatives that the problem tells
  bool algebraic_rows = false;  // takes order 0
  double largest_order = 2.0;
  bool two_sided = false;    // takes right derivatives and conditions
  bool checkpoints = false;  // takes Options::checkpoints, where it steps
};

// Where an error is measured: at a fixed time t > 0, at t_1 = h, or as the maximum over all grid times. A
// solution that starts like t^g shows different rates in them.
enum class Norm { end, first_step, maximum };

// What is proved of a scheme's rate at fixed times, and under which hypothesis.
struct Theorem {
  std::string_view name, hypothesis, rate;
};

// A function that runs a scheme, and one that steps over a grid.
using Solve = std::function<Trajectory(const Problem&, const Resolution&, const Options&)>;
using GridSolve = std::function<Trajectory(const Problem&, const Grid&, const Options&)>;

// A scheme is a row of facts and one function; it has no state.
struct Scheme {
  std::string_view id, title, source;
  Needs needs;
  // The theoretical rate of convergence as steps -> infinity on grids with this grading, for the default
  // options, of the components that are not algebraic rows; empty: there is none.
  std::function<double(const Problem&, const Smoothness&, double grading, Norm)> expected_rate{};
  // Runs the scheme. Preconditions: refusal(...) is empty. Never throws for numerical failure: see
  // Trajectory::ending. Of Options::at it returns the times that are its own or that it can interpolate.
  Solve solve;
  // A reason of its own to refuse, beyond its needs; empty function: none.
  std::function<std::optional<std::string>(const Problem&)> refuses{};
  // Its symbol with steps of this length and one correction. The problem is linear, has no algebraic
  // rows, no right derivatives, and is not refused.
  std::function<Symbol(const Problem&, double length)> symbol{};
  // The id of the scheme whose chains this one expands into components of equal order; empty: of none.
  std::string_view expansion_of{};
  std::optional<Theorem> theorem{};
  // The powers of t that its start weights make exact in f, from the orders of the problem alone; empty: it
  // has none.
  std::function<std::vector<double>(const Problem&)> start_powers{};
  std::string_view other_name{};  // another id that find_scheme takes; empty: none
};

// A scheme's solve from one that steps over a grid: unpacks the resolution.
Solve on_grid(GridSolve solve);

// Why the scheme does not fit the problem or the resolution, as half a sentence; nullopt: it fits.
std::optional<std::string> refusal(const Scheme& scheme, const Problem& problem,
                                   const Resolution& resolution);

// Why the scheme keeps no checkpoints of this problem, as half a sentence; nullopt: it does.
std::optional<std::string> refusal_of_checkpoints(const Scheme& scheme, const Problem& problem);

// All schemes, in the order of list.def.
std::span<const Scheme> schemes();

// The scheme with this id or other name, or nullptr.
const Scheme* find_scheme(std::string_view id);

}  // namespace fde
