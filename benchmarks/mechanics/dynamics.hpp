// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <set>

#include "fdebench/benchmarks/mechanics/mechanical_system.hpp"

namespace fde::bench::mechanics {

// The equations of motion of a system, solved for the acceleration, as expressions of t and the columns. With
// G = d^2 L/dv^2, R = df/dv, and df/dt = A v' + (df/dw) w' + convective rate along a motion, where A = R plus
// the part of df/dw at order 1, the reaction that compensates a defect x of df/dt is
//   -G^-1 R^T (A G^-1 R^T)^-1 x                                                    (Tarasov & Zaslavsky 36).
// In all results memory terms of order 1 are replaced by velocities. The algebra's pool must outlive this
// object.
class Dynamics {
 public:
  Dynamics(const MechanicalSystem& system, const Algebra& algebra);

  [[nodiscard]] const MechanicalSystem& system() const { return system_; }
  [[nodiscard]] const Algebra& algebra() const { return algebra_; }

  [[nodiscard]] const ExpressionMatrix& metric() const { return metric_; }
  [[nodiscard]] const Expressions& generalised_forces() const { return forces_; }  // G times the next
  [[nodiscard]] const Expressions& free_acceleration() const { return free_; }     // G^-1 of the forces
  [[nodiscard]] const Expressions& constraint() const { return value_; }           // f
  [[nodiscard]] const ExpressionMatrix& reaction_directions() const { return reaction_; }        // R
  [[nodiscard]] const ExpressionMatrix& acceleration_jacobian() const { return acceleration_; }  // A
  [[nodiscard]] const ExpressionMatrix& memory_jacobian() const { return memory_; }  // df/dw, 0 at order 1
  [[nodiscard]] const Expressions& convective_rate() const { return convective_; }   // df/dt + (df/dq) v
  // Without constraints these have no rows.
  [[nodiscard]] bool has_constraints() const { return !value_.empty(); }
  // The orders, other than 1, of the memory terms in constraints.
  [[nodiscard]] std::set<double> constraint_orders() const;
  // Whether constraints are affine in the velocity, with R a function of t and q.
  [[nodiscard]] bool is_affine() const { return !depends_on_motion(reaction_.entries); }
  // Whether d^2 L/dv^2 does not depend on v.
  [[nodiscard]] bool has_metric() const { return !depends_on_motion(metric_.entries); }
  // The order above 1 of a derivative in a force, beside memory terms of orders below 1 in the constraints:
  // its row D^(2 - order) w = v' contains their w'.
  [[nodiscard]] std::optional<double> force_order_with_memory_rates() const;

  // lambda that compensates a defect of df/dt, the acceleration G^-1 R^T lambda, and this for compensation.
  [[nodiscard]] Expressions multiplier(const Expressions& defect) const;
  [[nodiscard]] Expressions reaction(const Expressions& lambda) const;
  [[nodiscard]] Expressions compensation(const Expressions& defect) const {
    return reaction(multiplier(defect));
  }
  // The matrices of these: G^-1 R^T, and -G^-1 R^T (A G^-1 R^T)^-1.
  [[nodiscard]] const ExpressionMatrix& reaction_matrix() const { return raised_; }
  [[nodiscard]] ExpressionMatrix compensation_matrix() const;
  // The projection of x along the reaction onto A x = 0.
  [[nodiscard]] Expressions projected(const Expressions& x) const;
  // lambda with df/dt = 0, without the part in w'.
  [[nodiscard]] Expressions regular_multiplier() const;
  // A v'_free + convective rate: the defect of df/dt without reaction, without the part in w'.
  [[nodiscard]] Expressions free_defect() const;

  // The expressions with memory terms of order 1 replaced by velocities.
  [[nodiscard]] Expressions at_order_one(const Expressions& of) const;

 private:
  void set_free_motion();
  void set_constraints();
  [[nodiscard]] bool depends_on_motion(const Expressions& of) const;  // on v or w

  const MechanicalSystem& system_;
  const Algebra& algebra_;
  ExpressionMatrix metric_, reaction_, acceleration_, memory_;
  ExpressionMatrix raised_;   // G^-1 R^T
  ExpressionMatrix inverse_;  // (A G^-1 R^T)^-1
  Expressions forces_{}, free_{}, value_{}, convective_{};
};

}  // namespace fde::bench::mechanics
