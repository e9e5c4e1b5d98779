#pragma once

#include "two_sided/all_times.hpp"

namespace fde {

// Newton's linear equations of all times at once. With J_n = df/dy at t_n, K the rules of both sides, B what
// the unknown initial values p add and C the derivative of the conditions by y(0) and y(end):
//   x - K J x - B p = r,    C x = c.
// Given the right rows, the left ones are found by stepping from 0 on; given these, the right ones by
// stepping back from the end. So the equations become some for the right rows and p alone, without the
// stiffness of either side: z - (there and back)(z) = (there and back)(r). They are solved by GMRES, each
// application O(N).
class Linearisation {
 public:
  explicit Linearisation(const AllTimes& equations) : equations_(equations) {}

  // Takes the Jacobians at a guess, where the residual is known.
  void update(Run& run, const Guess& guess, const Residual& residual);

  // The Newton increment x, p for this residual; values that are not finite where there is none.
  [[nodiscard]] Guess increment(const Residual& residual) const;

  // Of Jacobians and of the vectors of GMRES.
  [[nodiscard]] std::size_t bytes() const;

 private:
  void differentiate_conditions(const Guess& guess, const Vec& conditions);
  [[nodiscard]] Vec conditions(const Rows& y) const;  // C y
  // Replaces y by the solution of y = given + K J y side after side: first the left rows with the right ones
  // as they come in, then the right ones.
  void forward_backward_sweep(const Rows& given, Rows& y) const;

  // The unknowns z of GMRES: the right rows, where there are left ones to need them, and the unknown initial
  // values.
  [[nodiscard]] Vec unknowns(const Rows& y, In conditions) const;
  [[nodiscard]] Rows right_part(const Vec& z) const;
  [[nodiscard]] Vec applied(const Vec& z) const;
  [[nodiscard]] Eigen::Index open_values() const;
  [[nodiscard]] double scale() const;

  const AllTimes& equations_;
  Matrix jacobians_;  // one column a time, or one for all
  Matrix left_inverses_, right_inverses_;
  Matrix by_start_, by_end_;  // of the conditions
};

}  // namespace fde
