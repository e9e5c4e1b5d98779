// SPDX-License-Identifier: MIT
#pragma once

#include "fdebench/schemes/rules/two_sided/linearisation.hpp"

namespace fde {

// Solves Newton's linear equations by elimination of the left rows. Given the right rows, the left ones
// follow by stepping forward from 0; given these, the right ones by stepping backward from the end. With this
// forward-backward sweep S the equations become equations for the right rows and p alone, without the
// stiffness of either side: z - S(z) = S(r). They are solved by GMRES, each application O(N). Without right
// rows and unknown initial values one sweep is the solution.
//
// Where solutions of one side alone grow by many powers of ten until the end, the result is useless. Only its
// residual shows this.
class CondensedSystem {
 public:
  // The linearisation must outlive this object.
  explicit CondensedSystem(const Linearisation& linearisation);

  // The increment of Newton's method for this residual.
  [[nodiscard]] GridFunction solution(const Residual& residual) const;
  // Memory of the vectors of GMRES.
  [[nodiscard]] std::size_t bytes() const;

 private:
  // The unknowns z of GMRES: the right rows, if there are left rows too, and the unknown initial values.
  [[nodiscard]] Vec unknowns(const Rows& y, In conditions) const;
  [[nodiscard]] Rows right_part(const Vec& z) const;
  [[nodiscard]] Vec applied(const Vec& z) const;

  const Linearisation& linearisation_;
  const GlobalEquations& equations_;
  Eigen::Index right_value_count_;  // number of values of right rows in z
  double scale_;                    // gives an unknown initial value the weight of a row at all times
};

}  // namespace fde
