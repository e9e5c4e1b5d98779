#pragma once

#include "implicit/newton_matrix.hpp"

namespace fde {

// Whether steps of a linear problem are too long for one of its growing modes.
//
// The matrix mass - kappa A of a step is singular where a mode grows without bound in one step: kappa_i is
// c_i h^(g_i), and where it is 1 / s^(g_i) that mode is e^(st). A longer step takes the solution through
// infinity and out on the other side, where the mode alternates in sign or decays: numbers that are finite
// and have nothing to do with the motion. The determinant has changed its sign then. It is compared with
// those of shorter steps, from half the length on down to where the matrix is dominated by its diagonal, and
// shorter ones have no zero. Where there are algebraic rows it goes on until rounding decides about the sign.
// The lengths between are not looked at, so two modes close to each other cancel.
class OutrunGrowth {
 public:
  // The problem is linear.
  explicit OutrunGrowth(const Problem& problem);

  // The matrix is factorised for kappa, and `solvable` is what it said of that. It is so afterwards.
  bool outruns(NewtonMatrix& matrix, const Vec& kappa, bool solvable);

  void state(Archive& archive) { archive(cleared_, sign_there_); }

 private:
  // Whether the determinant has its sign for this kappa and for all shorter steps.
  [[nodiscard]] bool dominated(const Vec& kappa) const;

  Vec orders_;
  Vec reach_;           // a_ii + sum_{j != i} |a_ij|; infinity in algebraic rows
  Vec cleared_;         // the kappa of the longest step that outran nothing; 0: there was none
  int sign_there_ = 0;  // of the determinant
};

}  // namespace fde
