#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "problem/problem.hpp"
#include "problem/smoothness.hpp"
#include "reference.hpp"
#include "scenes/parameters.hpp"
#include "stepping/trajectory.hpp"

namespace fde {

// The columns that a scene shows of the components that its problem solves for. All that is said of a scene
// beyond its problem, and all that is measured, is said of columns.
struct Outputs {
  std::vector<std::string> names{};
  std::function<void(double t, In y, Out columns)> of{};  // empty: the components in order
};

// Components as columns: components[c] is the one under names[c].
Outputs picked(std::vector<std::string> names, std::vector<Eigen::Index> components);

// E(columns) and, where the columns tell it, its exact rate of change along a solution,
//   dE/dt = power(t, columns) + sum_k shares_k(t, columns) d columns[rated[k]]/dt,
// whose second part is that of a reaction with memory.
struct Energy {
  std::function<double(In columns)> value{};
  std::function<double(double t, In columns)> power{};
  std::vector<Eigen::Index> rated{};
  std::function<void(double t, In columns, Out shares)> shares{};  // empty: none is rated
  explicit operator bool() const { return static_cast<bool>(value); }
};

// f(t, columns) = 0, one value a constraint.
struct Constraint {
  Eigen::Index size = 0;
  std::function<void(double t, In columns, Out f)> value{};
  explicit operator bool() const { return static_cast<bool>(value); }

  // |f(t, columns)|_inf, in the unit of f.
  [[nodiscard]] double drift(double t, In columns) const;
};

// A column that is the derivative of order in (0, 1) or (1, 2) of what another column is the first derivative
// of, and the powers of t with which the latter leaves its value at 0.
struct Memory {
  Eigen::Index derivative, velocity;
  double order;
  std::vector<double> powers{};
};

// The multipliers lambda of the constraints, and the power v.(df/dv)^T lambda that their reactions exchange.
struct Reactions {
  std::vector<std::string> names{};  // of the multipliers
  // lambda(t, columns, rates), rates the d/dt of the columns `rated`; these leave their values at 0 with
  // powers of t, and rates need not be finite there.
  std::vector<Eigen::Index> rated{};
  std::vector<double> powers{};
  std::function<void(double t, In columns, In rates, Out lambda)> multipliers{};
  std::function<double(double t, In columns, In lambda)> power{};
  std::optional<Vec> first{};  // lambda(0) where columns are rated; empty: it is unbounded
  Reference exact{};           // of lambda, where it is exactly known beside the columns
  explicit operator bool() const { return static_cast<bool>(multipliers); }
  // Whether the columns of a time tell lambda.
  [[nodiscard]] bool of_columns() const { return multipliers && rated.empty(); }
  // Whether lambda is known as exactly as the columns are.
  [[nodiscard]] bool known() const { return of_columns() || static_cast<bool>(exact.at); }
};

// The geometry of a mechanical system with T = 1/2 g_ij v^i v^j at a place q and a velocity v (Niminet &
// Blanuta 2009 without the factor 1/2 of their 2.6 and 2.8). n coordinates: tables have n rows and columns.
struct Geometry {
  Matrix metric;                    // g_ij(q)
  std::vector<Matrix> christoffel;  // christoffel[i](j, k) = Gamma^i_jk(q)
  Matrix connection;                // N^i_j = Gamma^i_jk v^k
  Vec semispray;                    // 2 G^i of the system without its constraints: v' = -2 G
  // With the multipliers that keep constraints without memory: lambda, 2 G*^i and N*^i_j = dG*^i/dv^j.
  // Empty where w' is in the reaction, which is no function of a state.
  Vec multipliers, constrained_semispray;
  Matrix constrained_connection;
};

// The names of the coordinates, the state at t = 0, and the geometry at any.
struct StateGeometry {
  std::vector<std::string> coordinates{};
  Vec place{}, velocity{};
  std::function<Geometry(In q, In v)> at{};
  // A velocity near v, the nearest where constraints are affine in it, that keeps the constraints at q.
  // Empty with memory: no state tells what they allow.
  std::function<Vec(In q, In v)> allowed{};
  explicit operator bool() const { return static_cast<bool>(at); }
};

// A function of the columns whose zeros along the path tell something, as where a body falls to the ground.
// The solution does not depend on it: a reference goes on behind one at which a run ends.
struct SceneEvent {
  std::string name{};
  std::function<double(double t, In columns)> value{};
  Crossing crossing = Crossing::either;
  bool ends = false;  // a solve, as Event::ends says
};

// A parameter at whose value here the solution is not continuous in it: what the equation has as the
// parameter tends to this value, in words.
struct Discontinuity {
  std::string parameter, limit;
};

// A problem and the columns it gives.
struct PosedProblem {
  Problem problem{};
  Outputs outputs{};
};

// A problem with what is known about it. What is absent is not computed, stored or shown.
struct Scene {
  std::string name{};  // its id and all parameters, under which its reference is kept; empty: it is not
  Problem problem{};
  // The times in (0, end) at which the right-hand side jumps, where they are found for an end; empty: those
  // of the problem are all.
  std::function<std::vector<double>(double end)> jumps_until{};
  std::string refusal{};  // why its equations have no problem in this form, where they have none
  Smoothness smoothness{};
  Outputs outputs{};
  Reference reference{};  // of the columns
  bool of_file = false;   // stated by a user: what is known about it is compared with two schemes
  std::optional<PosedProblem>
      reference_problem{};  // the same equations for a reference; empty: the problem itself
  Energy energy{};
  Constraint constraint{};
  std::vector<Memory> memories{};  // the columns that the drift evaluates independently
  Reactions reactions{};
  StateGeometry geometry{};
  std::vector<SceneEvent> events{};
  std::vector<Discontinuity> discontinuities{};
  Outputs motion{};  // of the columns: two or three coordinates of the point whose path shows the motion
};

// An equation as a file writes it, or for readers: the sum of coefficient D^order unknown = rhs, formulas.
struct WrittenEquation {
  struct Term {
    std::string coefficient, order;
  };
  std::string unknown;
  std::vector<Term> terms;
  std::string rhs;
  std::vector<std::string> initial;
};

// An equation that is there to be read: two formulas, in which D(x, a) and J(x, a) are the derivative and the
// integral of order a, D_right and J_right those from the end, sum(k, x) is a sum over k.
struct ShownEquation {
  std::string left, right;
};

// How a scene is made: one file in scenes/ and one line in scenes/list.def, or at run time.
struct SceneMaker {
  std::string id, title, source;
  std::vector<Parameter> parameters;
  std::function<Scene(const Parameters&)> make;
  std::string checksum{};  // of what a file says that it was read from; empty: it is of the code
  std::vector<WrittenEquation> equations{};  // empty: it says none
  std::vector<ShownEquation> shown{};        // where the former cannot say them
};

// Gives the problem this end, and the jumps up to it.
void set_end(Scene& scene, double end);

// The columns of components at a time, or of a path.
Vec columns_at(const Outputs& outputs, double t, In y);
Rows columns_of(const Outputs& outputs, const Trajectory& path);

// To first order: the sum over the components of |d columns / dy_i| bound_i.
Vec bound_of_columns(const Outputs& outputs, double t, const ReferenceValue& reference, In columns);

// The columns, then `energy` and `constraint` (the drift) where the scene has them.
std::vector<std::string> printed_names(const Scene& scene);
Vec printed_values(const Scene& scene, double t, In columns);

// The events of a scene as those of its problem, in the same order. The scene must live as long.
std::vector<Event> events_of(const Scene& scene);

// The multipliers and `power`, that of the reactions.
std::vector<std::string> reaction_names(const Scene& scene);
// Rates: of the columns that are rated; nothing: lambda is what it is at the start. NaN where it is
// unbounded.
Vec reaction_values(const Scene& scene, double t, In columns, const std::optional<Vec>& rates);
// The same of multipliers that are known, and of those that are exactly known at any time.
Vec with_power(const Scene& scene, double t, In columns, const Vec& lambda);
Vec exact_reactions(const Scene& scene, double t, In columns);

}  // namespace fde
