#pragma once

#include "two_sided/linearisation.hpp"

namespace fde {

// The solution of Newton's linear equations by elimination of a side. Given the right rows, the left ones are
// found by stepping from 0 on; given these, the right ones by stepping back from the end. So the equations
// become some for the right rows and p alone, without the stiffness of either side:
// z - (there and back)(z) = (there and back)(r). They are solved by GMRES, each application O(N). Without
// right rows and unknown initial values that is one march.
//
// Where solutions of one side alone grow by many powers of ten until the end, the result is none: nothing
// here tells, but the residual.
class Condensed {
 public:
  explicit Condensed(const Linearisation& linearisation);

  [[nodiscard]] Guess solution(const Residual& residual) const;
  // Of the vectors of GMRES.
  [[nodiscard]] std::size_t bytes() const;

 private:
  // The unknowns z of GMRES: the right rows, where there are left ones to need them, and the unknown initial
  // values.
  [[nodiscard]] Vec unknowns(const Rows& y, In conditions) const;
  [[nodiscard]] Rows right_part(const Vec& z) const;
  [[nodiscard]] Vec applied(const Vec& z) const;

  const Linearisation& linearisation_;
  const AllTimes& equations_;
  Eigen::Index open_values_;  // of the right rows in z
  double scale_;              // a number that is the same at all times weighs as much as a row of them
};

}  // namespace fde
