// SPDX-License-Identifier: MIT
#pragma once

#include <functional>

#include "fdebench/reference/special_functions/laplace/contour.hpp"

namespace fde::reference {

// Inverse Laplace transform at time 1,
//   f = 1/(2 pi i) int e^s F(s) ds,
// by the trapezoidal rule on one parabola that has every relevant singularity of F on its left:
//   s(theta) = sigma + i y - c + mu (1 + i theta)^2,  theta_k = k h,  sigma = largest real part.
// The singularities may be of any kind (poles of any order, branch points), each with a cut to the left; 0 is
// the usual one. A singularity whose e^(Re s*) is negligible against e^sigma may be left out. The work grows
// linearly with the distance of the singularities in imaginary direction.
class EnclosingContour {
 public:
  using Point = std::complex<long double>;

  struct Hints {
    long double order = 1.0L;   // of the strongest singularity, |s - s*|^-order
    long double growth = 0.0L;  // |F| grows like |s|^growth, or residues like |s*|^growth; not negative
  };

  // The error is about 10^-digits relative to e^sigma times the size of F. The singularities need only a few
  // correct digits. Throws std::invalid_argument if there are none, std::runtime_error if the contour takes
  // more than max_nodes nodes on each side.
  EnclosingContour(const std::vector<Point>& singularities, int digits, const Hints& hints);
  EnclosingContour(const std::vector<Point>& singularities, int digits)
      : EnclosingContour(singularities, digits, Hints{}) {}

  static constexpr int max_nodes = 200000;

  using Node = Contour<BigReal>::Node;  // s, its principal logarithm, weight including e^s
  // f ~ sum of weight F(s), evaluated with working_digits() digits.
  [[nodiscard]] std::vector<Node> nodes() const { return nodes_from(-count_); }
  // f ~ 2 Re sum of weight F(s), for F(conj s) = conj F(s) and singularities in conjugate pairs.
  [[nodiscard]] std::vector<Node> upper_nodes() const { return nodes_from(0); }
  [[nodiscard]] int count() const { return count_; }  // of nodes on each side
  [[nodiscard]] int working_digits() const { return working_digits_; }

  [[nodiscard]] long double sigma() const { return sigma_; }
  // |e^s| on the contour is at most e^(sigma + right_extent).
  [[nodiscard]] long double right_extent() const { return mu_ - c_; }
  // The node number k in [-count, count], in long double.
  [[nodiscard]] Point node(int k) const { return at(Point(static_cast<long double>(k) * step_, 0.0L)); }
  // |Im s - height()| is at most half_width() in the rectangle of log_bound().
  [[nodiscard]] long double height() const { return y_; }
  [[nodiscard]] long double half_width() const;

  // Whether e^(Re s*) is not negligible against e^sigma.
  [[nodiscard]] static bool is_relevant(const Point& singularity, long double sigma, int digits,
                                        const Hints& hints);
  // Whether a singularity that is not enclosed is inside the rectangle of log_bound() or near it.
  [[nodiscard]] bool is_near_rectangle(const Point& singularity) const;

  struct Disc {
    Point centre;
    long double radius;
  };
  // Logarithm of an upper bound of |F| on a disc; infinity where there is none: the disc is then split.
  using Majorant = std::function<long double(const Disc&)>;

  // Logarithm of a bound of |f - sum| without rounding, except that two parts are estimates. By the residue
  // theorem the error of the trapezoidal rule on |theta| <= L = (K + 1/2) h is at most
  // int |e^s F ds| / |e^(2 pi |Im theta| / h) -+ 1| around a rectangle of the theta-plane free of
  // singularities, whose boundary is covered with discs. The integral beyond L is estimated by
  // 4 e^(Re s(L)) |F(s(L))|, and omitted singularities by 0. Throws std::runtime_error where the smallest
  // disc has no bound or there are too many discs.
  [[nodiscard]] long double log_bound(const Majorant& majorant) const;

 private:
  struct Shape;
  void choose(const std::vector<Point>& enclosed, long double width, long double order);
  [[nodiscard]] Shape shape(const std::vector<Point>& enclosed, long double width, long double margin,
                            long double right_extent, long double c) const;
  [[nodiscard]] Point at(const Point& theta) const;
  [[nodiscard]] std::vector<Node> nodes_from(int first) const;

  class Boundary;

  long double sigma_ = 0.0L, y_ = 0.0L, c_ = 0.0L, mu_ = 1.0L, step_ = 1.0L;
  long double above_ = 0.0L, below_ = 0.0L;  // the rectangle: -below <= Im theta <= above
  int count_ = 0, working_digits_ = 0;
};

}  // namespace fde::reference
