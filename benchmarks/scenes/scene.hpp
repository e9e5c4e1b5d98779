// SPDX-License-Identifier: MIT
#pragma once

#include <complex>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "fdebench/benchmarks/scenes/parameters.hpp"
#include "fdebench/benchmarks/scenes/scene_facts.hpp"
#include "fdebench/reference/reference.hpp"
#include "fdebench/schemes/problem/problem.hpp"
#include "fdebench/schemes/problem/smoothness.hpp"
#include "fdebench/schemes/stepping/trajectory.hpp"

namespace fde::bench {

// The columns (output variables) of a scene, computed from the components of its problem. Energy,
// constraints, references and measures are functions of the columns.
struct Outputs {
  std::vector<std::string> names{};
  std::function<void(double t, In y, Out columns)> evaluate{};  // empty: the components in order
};

// Outputs that are components: column names[c] is component components[c].
Outputs select_components(std::vector<std::string> names, std::vector<Eigen::Index> components);

// E(columns) and, if it can be computed from the columns, its exact rate of change along a solution,
//   dE/dt = power(t, columns) + sum_k c_k(t, columns) d columns[differentiated_columns[k]]/dt,
// with the rate_coefficients c_k. The second term is the power of a reaction with memory.
struct Energy {
  std::function<double(In columns)> value{};
  std::function<double(double t, In columns)> power{};
  std::vector<Eigen::Index> differentiated_columns{};
  std::function<void(double t, In columns, Out shares)> rate_coefficients{};  // empty: no such term
  explicit operator bool() const { return static_cast<bool>(value); }
};

// f(t, columns) = 0, one value a constraint.
struct Constraint {
  Eigen::Index size = 0;
  std::function<void(double t, In columns, Out f)> value{};
  explicit operator bool() const { return static_cast<bool>(value); }

  // |f(t, columns)|_inf, in the unit of f.
  [[nodiscard]] double drift(double t, In columns) const;

  // The size of what cancels in f: sum_i |f(t, columns) - f(t, columns without i)|, column i being 0 in the
  // latter; the largest of the constraints.
  [[nodiscard]] double terms(double t, In columns) const;
};

// Column `derivative` is the Caputo derivative of this order, in (0, 1) or (1, 2), of the antiderivative of
// column `velocity`. `powers`: the exponents p of the terms t^p with which the velocity starts at t = 0.
struct MemoryColumn {
  Eigen::Index derivative, velocity;
  double order;
  std::vector<double> powers{};
};

// The multipliers lambda of the constraints, and the power v.(df/dv)^T lambda that their reactions exchange.
struct Reactions {
  std::vector<std::string> names{};  // of the multipliers
  // lambda(t, columns, rates), where rates is d/dt of the columns `differentiated_columns`. At t = 0 these
  // columns start with terms t^p, p in `start_exponents`, and rates need not be finite there.
  std::vector<Eigen::Index> differentiated_columns{};
  std::vector<double> start_exponents{};
  std::function<void(double t, In columns, In rates, Out lambda)> multipliers{};
  std::function<double(double t, In columns, In lambda)> power{};
  // lambda(0) if `differentiated_columns` is not empty; nullopt: lambda is unbounded at t = 0.
  std::optional<Vec> initial_multipliers{};
  reference::Reference exact{};  // of lambda, if it has an exact reference of its own
  explicit operator bool() const { return static_cast<bool>(multipliers); }
  // Whether lambda is a function of t and the columns at that time.
  [[nodiscard]] bool depends_on_columns_only() const { return multipliers && differentiated_columns.empty(); }
  // Whether lambda is known as exactly as the columns.
  [[nodiscard]] bool has_exact_multipliers() const {
    return depends_on_columns_only() || static_cast<bool>(exact.at);
  }
};

// The geometry of a mechanical system with T = 1/2 g_ij v^i v^j at a position q and a velocity v (Niminet &
// Blanuta 2009 without the factor 1/2 of their 2.6 and 2.8). With n coordinates, tables are n x n.
struct Geometry {
  Matrix metric;                    // g_ij(q)
  std::vector<Matrix> christoffel;  // christoffel[i](j, k) = Gamma^i_jk(q)
  Matrix connection;                // N^i_j = Gamma^i_jk v^k
  Vec semispray;                    // 2 G^i of the unconstrained system: v' = -2 G
  // For constraints without memory: lambda, 2 G*^i and N*^i_j = dG*^i/dv^j. Empty if the reaction contains
  // w', which is not a function of the state.
  Vec multipliers, constrained_semispray;
  Matrix constrained_connection;
};

// The names of the coordinates, the state at t = 0, and the geometry at any state (q, v).
struct StateGeometry {
  std::vector<std::string> coordinates{};
  Vec position{}, velocity{};
  std::function<Geometry(In q, In v)> at{};
  // A velocity near v, the nearest where constraints are affine in it, that keeps the constraints at q.
  // Empty with memory: no state tells what they allow.
  std::function<Vec(In q, In v)> allowed{};
  explicit operator bool() const { return static_cast<bool>(at); }
};

// A function of the columns whose zeros along the trajectory are located, for instance an impact on the
// ground. The solution does not depend on it: a reference continues past an event that ends a solve.
struct SceneEvent {
  std::string name{};
  std::function<double(double t, In columns)> value{};
  Crossing crossing = Crossing::either;
  bool terminal = false;  // whether a zero ends the solve, as Event::terminal
  // Event::times up to an end; empty: the function depends on unknowns.
  std::function<std::vector<double>(double end)> times{};
};

// The transfer function G(s) = sum c s^q / sum c s^q of an unknown, from its input.
struct TransferFunction {
  struct Term {
    double coefficient, order;
  };
  std::string name{};  // of the unknown
  std::vector<Term> numerator{}, denominator{};
};

// G(i frequency): sin(frequency t) as input leaves |G| sin(frequency t + arg G) in the long run, if G is
// stable. Precondition: frequency > 0.
std::complex<double> frequency_response(const TransferFunction& transfer, double frequency);

// A problem and its output columns.
struct PosedProblem {
  Problem problem{};
  Outputs outputs{};
};

// What a right-hand side does as a function of t alone, up to a given end: Problem::jump_times, kink_times
// and step_limits.
struct LoadTimes {
  std::vector<double> jumps{}, kinks{};
  std::vector<StepLimit> limits{};
};

// A problem with what is known about it. What is absent is not computed, stored or shown.
struct Scene {
  std::string name{};  // id and all parameters: key of the cached reference; empty: not cached
  Problem problem{};
  // The time that users read and write at t = 0 of the problem; all members count time from there.
  double start = 0.0;
  // What the right-hand side does as a function of t alone, if it is computed for a given end; empty: the
  // jump times and the step limits of the problem are complete.
  std::function<LoadTimes(double end)> load_times{};
  std::string ill_posed_reason{};  // reason why the equations cannot be posed in this form; empty: they can
  Smoothness smoothness{};
  Outputs outputs{};
  std::vector<std::string> row_names{};  // of the rows of the problem, for messages; empty: as of the columns
  reference::Reference reference{};      // of the columns
  // The reference for another end, if it depends on that; empty: it does not.
  std::function<reference::Reference(double end)> reference_to{};
  bool from_file = false;  // from an equation file: its reference is checked against two schemes
  std::optional<PosedProblem> reference_problem{};  // another formulation for the reference; empty: `problem`
  // Where the problem approximates an equation of another kind: the same with a finer approximation. The
  // difference of both solutions is part of the bound of the reference.
  std::optional<PosedProblem> comparison_problem{};
  // Functions of t and the columns that are infinite at t = 0: printed beside the columns, whose errors are
  // theirs.
  Outputs singular{};
  std::vector<TransferFunction> transfers{};
  Energy energy{};
  Constraint constraint{};
  std::vector<MemoryColumn> memory_columns{};  // columns that the drift measure recomputes independently
  Reactions reactions{};
  StateGeometry geometry{};
  std::vector<SceneEvent> events{};
  std::vector<Discontinuity> discontinuities{};
  // Functions of the columns: two or three coordinates of the point whose path is drawn.
  Outputs display_path{};
};

// How a scene is made: one file in scenes/, in C++ or an equation file, and one line in scenes/list.def, or
// at run time.
struct SceneFactory {
  std::string id, title, source;
  std::vector<Parameter> parameters;
  std::function<Scene(const Parameters&)> make;
  std::string checksum{};  // of the contents of a user's equation file; empty: the scene is compiled in
  std::vector<EquationFormula> equations{};          // empty: no equations as text
  std::vector<DisplayEquation> display_equations{};  // used if `equations` cannot express them
  std::string toml{};  // the contents of its equation file; empty: the scene is made in C++
};

// Sets the end of the problem and recomputes its jumps up to it.
void set_end(Scene& scene, double end);

// The columns from the components at one time, or along a trajectory (one row a column, one column a time).
Vec columns_at(const Outputs& outputs, double t, In y);
Rows columns_of(const Outputs& outputs, const Trajectory& path);

// First-order error bound of the columns: the sum over the components of |d columns / dy_i| bound_i.
Vec propagated_bound(const Outputs& outputs, double t, const reference::ReferenceValue& reference,
                     In columns);

// The columns, then `singular`, `energy` and `constraint` (the drift) where the scene has them.
std::vector<std::string> printed_names(const Scene& scene);
Vec printed_values(const Scene& scene, double t, In columns);
// Whether a printed value is finite unless something went wrong.
bool is_regular(const Scene& scene, double t, Eigen::Index printed);

// The events of a scene as events of its problem, in the same order. `scene` must outlive the result.
std::vector<Event> events_of(const Scene& scene);

// The names of the multipliers, then `power`, the power of the reactions.
std::vector<std::string> reaction_names(const Scene& scene);
// The multipliers and their power. `rates`: d/dt of the columns `differentiated_columns`; nullopt: the values
// at t = 0, NaN where lambda is unbounded.
Vec reaction_values(const Scene& scene, double t, In columns, const std::optional<Vec>& rates);
// Given multipliers with their power; and the exact multipliers at any time with theirs.
Vec with_reaction_power(const Scene& scene, double t, In columns, const Vec& lambda);
Vec exact_reactions(const Scene& scene, double t, In columns);

}  // namespace fde::bench
