// SPDX-License-Identifier: MIT
#pragma once

#include <boost/container/static_vector.hpp>

#include "fdebench/reference/special_functions/laplace/sheets.hpp"
#include "fdebench/reference/special_functions/numbers/double_double.hpp"

// The cases in the evaluation of E_{alpha,beta}(z), the inverse Laplace transform at time 1 of
//   F(s) = s^(alpha-beta) / (s^alpha - z),
// for every number type.
namespace fde::reference {

enum class EvaluationForm {
  at_zero,        // z = 0: 1 / Gamma(beta)
  residues_only,  // all powers of s in F are integers: no branch cut, only residues
  shifted_beta,   // 1 / Gamma(beta) = 0, the first term of the series: z E_{alpha,alpha+beta}(z) cancels less
  on_contour      // a contour around the cut, and the residues of the poles outside it
};

// For large |z| the first terms of the asymptotic expansion may be split off ("peeled"), which is exact:
//   E_{alpha,beta}(z) = -sum_{k=1}^m z^-k / Gamma(beta - alpha k) + z^-m E_{alpha,beta-m alpha}(z).

inline bool is_integer(const DoubleDouble& x) { return x.lo == 0.0 && std::floor(x.hi) == x.hi; }
inline double leading_part(const DoubleDouble& x) { return x.hi; }
inline const BigReal& leading_part(const BigReal& x) { return x; }

template <class Real>
bool is_pole_of_gamma(const Real& x) {
  return leading_part(x) <= 0 && is_integer(x);
}

template <class Alpha, class Beta, class Argument>
EvaluationForm evaluation_form(const Alpha& alpha, const Beta& beta, const Argument& z) {
  if (z == Argument(0)) return EvaluationForm::at_zero;
  if (is_integer(alpha) && is_integer(beta) && leading_part(beta) <= alpha)
    return EvaluationForm::residues_only;
  return is_pole_of_gamma(beta) ? EvaluationForm::shifted_beta : EvaluationForm::on_contour;
}

// A pole s*^alpha = z, log s* = (log z + 2 pi i sheet) / alpha.
template <class Real>
struct Pole {
  int sheet;
  Complex<Real> log;
};

// As alpha <= 5, the poles with |arg s*| < 2 pi are on the sheets -max_sheet, ..., max_sheet.
inline constexpr int max_sheet = 6;
template <class T>
using PerSheet = boost::container::static_vector<T, 2 * max_sheet + 1>;

template <class Real>
struct Poles {
  PerSheet<Pole<Real>> on_near_sheets{};  // those with |arg s*| < 2 pi
  // Of the other poles, as in ContourBound::Quotient.
  double nearest_other_argument = std::numeric_limits<double>::infinity();
};

// The poles on the sheets first_sheet, ..., max_sheet. Poles nearer to 0 than the range of double count as
// poles on another sheet.
template <class Real>
Poles<Real> poles_of(const Real& alpha, const Complex<Real>& log_z, int first_sheet = -max_sheet) {
  using std::abs;
  constexpr double most_log = 600.0, most_log_of_contour = 20.0;
  const Real log_size = real_part<Real>(log_z);
  const bool next_to_zero = log_size / alpha < -most_log;
  Poles<Real> poles;
  const auto on_far_sheets = [&](const Real& distance) {
    poles.nearest_other_argument = std::min(poles.nearest_other_argument, static_cast<double>(distance));
  };
  for (int sheet = first_sheet; sheet <= max_sheet; ++sheet) {
    const Complex<Real> log = log_on_sheet<Real>(log_z, sheet);
    const Real argument = abs(imag_part<Real>(log));
    if (next_to_zero) {
      on_far_sheets(Real(-log_size - most_log_of_contour * alpha));
    } else if (argument < 2 * pi<Real>() * alpha) {
      poles.on_near_sheets.push_back({sheet, Complex<Real>(log / alpha)});
    } else {
      on_far_sheets(argument);
    }
  }
  return poles;
}

}  // namespace fde::reference
