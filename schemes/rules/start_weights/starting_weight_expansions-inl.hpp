// SPDX-License-Identifier: MIT
// Starting weights at large n, from the singularities of the generating function of e_p. Included once for
// each vector target.

#if defined(FDE_STARTING_WEIGHT_EXPANSIONS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef FDE_STARTING_WEIGHT_EXPANSIONS_INL
#undef FDE_STARTING_WEIGHT_EXPANSIONS_INL
#else
#define FDE_STARTING_WEIGHT_EXPANSIONS_INL
#endif

#include <hwy/highway.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <optional>
#include <vector>

#include "fdebench/schemes/rules/start_weights/decaying_part-inl.hpp"
#include "fdebench/schemes/rules/start_weights/start_weights.hpp"
#include "fdebench/schemes/rules/start_weights/starting_weight_equations-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace fde::HWY_NAMESPACE {

// With A_p(zeta) = sum_j j^p zeta^j and zeta = exp(-t),
//   A_p = Gamma(p+1) t^(-p-1) + sum_k zeta(-p-k) (-t)^k / k!,   omega = t^(-g) sum_k c_k t^k,
// and t^(-a) is the generating function of n^(a-1) / Gamma(a), up to a function regular at t = 0. The product
// omega A_p without its first term is the generating function of -kappa e_p:
//   -kappa e_p(n) = n^(p+g) sum_k method[k][p] n^(-k) + n^(g-1) sum_k start[k][p] n^(-k).
// At zeta = -exp(-t) A_p has (2^(1+p+k) - 1) zeta(-p-k) in place of zeta(-p-k), and omega starts like t^g:
//   (-1)^n n^(-g-1) sum_k alternating[k][p] n^(-k).
template <class Real>
class Expansions {
 public:
  static constexpr std::size_t lanes = Real::lanes;
  static constexpr std::size_t zeta_terms = 21;  // with values of zeta, which are smaller by (2 pi)^-k

  explicit Expansions(const WeightTable& table, const WeightEquations<Real>& equations)
      : all_(equations), rule_(*table.family->multistep), stride_(equations.stride), terms_(terms_at(64)) {
    const bool decays = rule_.decay > 0.5;  // otherwise decay^64 is negligible
    const std::size_t zetas = decays ? DecayingPart<Real>::zeta_terms : zeta_terms;
    zetas_ = Numbers<Real>(zetas * stride_);
    for (std::size_t p = 0; p < all_.count; p += lanes) {
      const auto values =
          zeta_series(all_.power(p), all_.gammas.from(p), all_.integer_powers, p, stride_, zetas);
      for (std::size_t k = 0; k < zetas; ++k) zetas_.put(k * stride_ + p, values.from(k * lanes));
    }
    // zeta(0) = -1/2; only for p = 0 the sample at j = 0 is not 0 but 1.
    zetas_.set(0, Real(0.5));
    expand_at_one();
    alternates =
        rule_.exponent > 0 && rule_.base[1] == rule_.base[0] && table.order != std::floor(table.order);
    if (alternates) expand_at_minus_one();
    if (decays) decaying = DecayingPart<Real>(rule_, equations, zetas_, of_start_).weights();
  }

  // How many terms are not negligible from this step on. After the first `rate` they decay like k! / (0.9
  // n)^k at least: 0.9 is the distance of the nearest other singularity, of those of all rules, from t = 0.
  [[nodiscard]] std::size_t terms_at(std::size_t step) const {
    std::size_t k = 1;
    for (double term = 1.0; term > 1e-21; ++k)
      term *= static_cast<double>(k) / (0.9 * static_cast<double>(step));
    return static_cast<std::size_t>(rule_.rate) + k;
  }

  bool alternates;
  Numbers<Real> method, start, alternating;
  std::optional<DecayingWeights> decaying;

 private:
  // 1 / Gamma(z - k) for k = 0, 1, ..., from the first.
  static Numbers<Real> reciprocal_gammas(Real value, Real z, std::size_t count) {
    Numbers<Real> values(count);
    for (std::size_t k = 0; k < count; ++k) {
      values.set(k, value);
      z = z - Real(1.0);
      value = value * z;
    }
    return values;
  }

  // The series of the product of c and the series with these rows, the term k times factors[k].
  [[nodiscard]] Numbers<Real> times(const Numbers<Real>& c, const Numbers<Real>& rows, std::size_t given,
                                    const Numbers<Real>& factors) const {
    Numbers<Real> result(terms_ * stride_);
    for (std::size_t k = 0; k < terms_; ++k) {
      for (std::size_t p = 0; p < all_.count; p += lanes) {
        SumOfProducts<Real> sum;
        for (std::size_t i = 0; i < std::min(given, k + 1); ++i)
          sum.add(rows.from(i * stride_ + p), c.each(k - i));
        result.put(k * stride_ + p, sum.value() * factors.each(k));
      }
    }
    return result;
  }

  void expand_at_one() {
    const Numbers<Real> c = all_.factors.at_one(terms_);
    const Real one(1.0), g = all_.factors.order;
    method = Numbers<Real>(terms_ * stride_);
    for (std::size_t p = 0; p < all_.count; p += lanes) {
      Real factor = all_.ratios.from(p), z = all_.power(p) + g;
      for (std::size_t k = 0; k < terms_; ++k) {
        // c_0 = 1 is the exact integral, which cancels; c_k = 0 for 0 < k < rate, up to rounding.
        if (k >= static_cast<std::size_t>(rule_.rate)) method.put(k * stride_ + p, factor * c.each(k));
        factor = factor * z;
        z = z - one;
      }
    }
    of_start_ = reciprocal_gammas(one / gamma(g), g, terms_);
    start = times(c, zetas_, zeta_terms, of_start_);
  }

  void expand_at_minus_one() {
    const Real g = all_.factors.order, one(1.0);
    Numbers<Real> base = exponential_mean<Real>(terms_), sum(2), none(1);
    for (std::size_t k = 0; k < terms_; ++k) base.set(k, base.each(k) * all_.factors.base.each(0));
    sum.set(0, one);
    sum.set(1, one);
    none.set(0, one);
    const auto c = all_.factors.combine(compose_with_exponential(sum, terms_), base, none, terms_);
    Numbers<Real> samples(zeta_terms * stride_);
    for (std::size_t p = 0; p < all_.count; p += lanes) {
      Real two = Real(2.0) * all_.integer_powers.from(2 * stride_ + p);
      for (std::size_t k = 0; k < zeta_terms; ++k) {
        samples.put(k * stride_ + p, (two - one) * zetas_.from(k * stride_ + p));
        two = two * Real(2.0);
      }
    }
    // 1 / Gamma(-g) without poles.
    const Real first = -g * (one - g) * (Real(2.0) - g) / gamma(Real(3.0) - g);
    alternating = times(c, samples, zeta_terms, reciprocal_gammas(first, -g, terms_));
  }

  const WeightEquations<Real>& all_;
  const MultistepRule& rule_;
  std::size_t stride_, terms_;
  Numbers<Real> zetas_, of_start_;
};

// Chebyshev coefficients of the expansions on pieces [begin, 2 begin].
template <class Real>
class PieceWeights {
 public:
  static constexpr std::size_t lanes = Real::lanes;
  // For functions whose only singularity is at n = 0: (3 + sqrt 8)^-22 = 1e-17.
  static constexpr std::size_t points = 22, width = (points + lanes - 1) / lanes * lanes;

  PieceWeights(const WeightEquations<Real>& equations, const Expansions<Real>& expansions)
      : all_(equations),
        expansions_(expansions),
        cosines_((4 * points + lanes - 1) / lanes * lanes),
        points_(width),
        powers_(points * equations.stride) {
    std::vector<double> integers(cosines_.size());
    std::iota(integers.begin(), integers.end(), 0.0);
    const Real angle = Real::pi() / Real(2 * points);
    for (std::size_t m = 0; m < cosines_.size(); m += lanes)
      cosines_.put(m, sine_and_cosine(angle * Real::of_doubles(&integers[m])).cosine);
    for (std::size_t i = 0; i < width; ++i)
      points_.set(i, Real(1.5) + Real(0.5) * cosines_.each((2 * i + 1) % (4 * points)));
    Numbers<Real> logarithms(width);
    for (std::size_t i = 0; i < width; i += lanes) logarithms.put(i, log(points_.from(i)));
    for (std::size_t i = 0; i < points; ++i) {
      for (std::size_t p = 0; p < all_.stride; p += lanes)
        powers_.put(i * all_.stride + p, exp(all_.power(p) * logarithms.each(i)));
    }
  }

  // On begin 2^piece <= n <= begin 2^(piece+1).
  [[nodiscard]] StartingWeights::ChebyshevPiece at(std::size_t begin, std::size_t piece) const {
    const std::size_t stride = all_.stride, count = all_.count;
    const std::size_t used = expansions_.terms_at(begin << piece);
    Numbers<Real> scale(stride), inverse(used * width), e(stride), other(stride);
    for (std::size_t p = 0; p < stride; p += lanes) {
      Real value = all_.integer_powers.from(begin * stride + p);
      for (std::size_t i = 0; i < piece; ++i) value = value * all_.integer_powers.from(2 * stride + p);
      scale.put(p, value);
    }
    for (std::size_t i = 0; i < width; i += lanes) {
      const Real x = Real(1.0) / (points_.from(i) * Real(begin << piece));
      Real power(1.0);
      for (std::size_t k = 0; k < used; ++k) {
        inverse.put(k * width + i, power);
        power = power * x;
      }
    }
    const auto sum = [&](const Numbers<Real>& series, std::size_t p, std::size_t i) HWY_ATTR {
      SumOfProducts<Real> value;
      for (std::size_t k = 0; k < used; ++k)
        value.add(series.from(k * stride + p), inverse.each(k * width + i));
      return value.value();
    };
    Numbers<Real> smooth(points * stride), alternating(expansions_.alternates ? points * stride : 0);
    for (std::size_t i = 0; i < points; ++i) {
      const Real of_order = powers_.each(i * stride + count) * scale.each(count),
                 by_x = inverse.each(width + i);
      const Real at_one = -of_order / all_.kappa.each(0),
                 at_minus_one = -by_x / (of_order * all_.kappa.each(0));
      for (std::size_t p = 0; p < count; p += lanes) {
        const Real power = powers_.from(i * stride + p) * scale.from(p);
        e.put(p, at_one * (power * sum(expansions_.method, p, i) + by_x * sum(expansions_.start, p, i)));
        if (expansions_.alternates) other.put(p, at_minus_one * sum(expansions_.alternating, p, i));
      }
      all_.solve(e, 0, count, smooth, i * stride);
      if (expansions_.alternates) all_.solve(other, 0, count, alternating, i * stride);
    }
    return {coefficients(smooth), coefficients(alternating), Matrix()};
  }

 private:
  // Chebyshev coefficients, one row each, from the values at the Chebyshev points.
  [[nodiscard]] Matrix coefficients(const Numbers<Real>& values) const {
    Matrix made(values.size() > 0 ? points : 0, all_.count);
    Numbers<Real> row(all_.stride);
    for (Eigen::Index k = 0; k < made.rows(); ++k) {
      for (std::size_t j = 0; j < all_.count; j += lanes) {
        SumOfProducts<Real> sum;
        for (std::size_t i = 0; i < points; ++i) {
          const std::size_t angle = static_cast<std::size_t>(k) * (2 * i + 1) % (4 * points);
          sum.add(values.from(i * all_.stride + j), cosines_.each(angle));
        }
        row.put(j, sum.value() * (Real(k == 0 ? 1.0 : 2.0) / Real(points)));
      }
      for (Eigen::Index j = 0; j < made.cols(); ++j) made(k, j) = row.rounded(static_cast<std::size_t>(j));
    }
    return made;
  }

  const WeightEquations<Real>& all_;
  const Expansions<Real>& expansions_;
  Numbers<Real> cosines_;  // cos(pi m / (2 points))
  Numbers<Real> points_;   // the Chebyshev points of [1, 2]
  Numbers<Real> powers_;   // their powers, in rows
};

}  // namespace fde::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
