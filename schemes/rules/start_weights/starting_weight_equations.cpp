// SPDX-License-Identifier: MIT
#include "fdebench/schemes/rules/start_weights/starting_weight_equations.hpp"

#include <algorithm>
#include <cmath>

#include "fdebench/schemes/rules/start_weights/number_series.hpp"

namespace fde {
namespace {

constexpr std::size_t terms = 33;       // of the expansions, for steps from `nearest` on
constexpr std::size_t zeta_terms = 21;  // terms with zeta values, which are smaller by (2 pi)^-k
constexpr std::size_t nearest = 64;
constexpr double negligible = 1e-24;

// K, a multiple of the block size of StartingCorrection.
std::size_t near_steps(const MultistepRule& rule) {
  constexpr std::size_t together = 32;
  const double decay = rule.decay == 0.0 ? 0.0 : std::log(negligible) / std::log(rule.decay);
  const auto steps = std::max(nearest, static_cast<std::size_t>(decay));
  return (steps + together - 1) / together * together;
}

// The inverse of the matrix j^p, for the first `count` powers: row j has the factors of e_p in W(n, j).
NumberMatrix inverse_of_first(const NumberMatrix& whole_powers, std::size_t count) {
  NumberMatrix matrix;
  for (std::size_t p = 0; p < count; ++p) {
    matrix.emplace_back(whole_powers[p].begin(),
                        whole_powers[p].begin() + static_cast<std::ptrdiff_t>(count));
  }
  return inverse(std::move(matrix));
}

}  // namespace

struct StartingWeightEquations::Numbers {
  Number g, kappa;
  std::size_t near;
  std::vector<double> exponents;
  const MultistepRule& rule;
  NumberMatrix powers;    // j^p for each p
  NumberVector of_order;  // j^g
  NumberVector w;
  NumberVector ratios;   // Gamma(p+1) / Gamma(p+g+1)
  NumberMatrix factors;  // inverse_of_first for all powers; empty where only growth is computed

  Numbers(const WeightTable& table, const std::vector<double>& p, std::size_t steps)
      : g(table.order), near(steps), exponents(p), rule(*table.family->multistep) {
    const std::size_t last = std::max({near, p.size(), nearest});
    for (const double power : p) {
      powers.push_back(integer_powers(power, last));
      ratios.push_back(tgamma(Number(power) + 1) / tgamma(Number(power) + g + 1));
    }
    of_order = integer_powers(table.order, near);
    w = multistep_weights<Number>(rule, g, near + 1);
    kappa = pow(Number(rule.base[0]) / rule.denominator, rule.exponent * g) * correction<Number>(rule, g)[0];
  }

  // e_p(1), ..., e_p(near)
  [[nodiscard]] NumberVector near_moments(std::size_t p) const {
    NumberVector e;
    const auto& values = powers[p];
    const Number scale = ratios[p] / kappa;
    for (std::size_t n = 1; n <= near; ++n) {
      Number sum = scale * values[n] * of_order[n];
      for (std::size_t j = 0; j <= n; ++j) sum -= w[n - j] * values[j];
      e.push_back(sum);
    }
    return e;
  }

  // max over n <= near of sum_j |W(n, j)| / max(1, n^(g-1)), for the powers of the inverse matrix.
  [[nodiscard]] double growth(const NumberMatrix& moments, const NumberMatrix& inverted) const {
    double largest = 0.0;
    for (std::size_t n = 1; n <= near; ++n) {
      const double size = std::max(1.0, std::pow(static_cast<double>(n), static_cast<double>(g) - 1.0));
      double sum = 0.0;
      for (const auto& row : inverted) sum += std::abs(static_cast<double>(weight(row, moments, n)));
      largest = std::max(largest, sum / size);
    }
    return largest;
  }

  // W(n, j) from the e_p(n) of all powers.
  [[nodiscard]] double weight(std::size_t j, const NumberVector& e) const {
    Number sum = 0;
    for (std::size_t p = 0; p < e.size(); ++p) sum += factors[j][p] * e[p];
    return static_cast<double>(sum);
  }

  static Number weight(const NumberVector& row, const NumberMatrix& moments, std::size_t n) {
    Number sum = 0;
    for (std::size_t p = 0; p < row.size(); ++p) sum += row[p] * moments[p][n - 1];
    return sum;
  }

  // The series of omega(exp(-t)) t^g.
  [[nodiscard]] NumberVector at_one() const {
    return product(power_of_series(exponential_mean(terms), -g), other_factors());
  }

  // The series of omega(-exp(-t)) t^(-g), for the rule with the base 1 + zeta.
  [[nodiscard]] NumberVector at_minus_one() const {
    NumberVector base = exponential_mean(terms);
    for (auto& coefficient : base) coefficient /= rule.denominator;
    return product(power_of_series(base, g),
                   power_of_series(compose_with_exponential({Number(1), Number(1)}, terms), -g));
  }

  // The product of the factors of omega(exp(-t)) that are regular at t = 0.
  [[nodiscard]] NumberVector other_factors() const {
    NumberVector base;
    for (const int coefficient : rule.base) base.push_back(Number(coefficient) / rule.denominator);
    return product(power_of_series(compose_with_exponential(base, terms), rule.exponent * g),
                   compose_with_exponential(correction<Number>(rule, g), terms));
  }

  [[nodiscard]] bool alternates() const {
    return rule.exponent > 0 && rule.base[1] == rule.base[0] && g != floor(g);
  }
};

Matrix StartingWeightEquations::tabulated_weights() const {
  NumberMatrix moments;
  for (std::size_t p = 0; p < numbers_->exponents.size(); ++p) moments.push_back(numbers_->near_moments(p));
  Matrix weights(numbers_->near, moments.size());
  for (Eigen::Index n = 1; n <= weights.rows(); ++n) {
    for (Eigen::Index j = 0; j < weights.cols(); ++j) {
      weights(n - 1, j) = static_cast<double>(Numbers::weight(numbers_->factors[static_cast<std::size_t>(j)],
                                                              moments, static_cast<std::size_t>(n)));
    }
  }
  return weights;
}

namespace {

// sum_k a_k x^(-k), until three successive terms are negligible: every second term may be 0.
Number in_inverse(const NumberVector& a, const NumberVector& inverse_powers) {
  static const Number tiny = ldexp(Number(1), -120);
  Number sum = 0;
  int small = 0;
  for (std::size_t k = 0; k < a.size() && small < 3; ++k) {
    const Number term = a[k] * inverse_powers[k];
    sum += term;
    small = k > 3 && abs(term) < tiny * abs(sum) ? small + 1 : 0;
  }
  return sum;
}

NumberVector inverse_powers_of(const Number& x) {
  NumberVector powers{Number(1)};
  const Number inverse = 1 / x;
  for (std::size_t k = 1; k < terms; ++k) powers.push_back(powers.back() * inverse);
  return powers;
}

}  // namespace

// With A_p(zeta) = sum_j j^p zeta^j and zeta = exp(-t),
//   A_p = Gamma(p+1) t^(-p-1) + sum_k zeta(-p-k) (-t)^k / k!,   omega = t^(-g) sum_k c_k t^k,
// and t^(-a) is the generating function of n^(a-1) / Gamma(a), up to a function regular at t = 0. The product
// omega A_p without its first term is the generating function of -kappa e_p:
//   -kappa e_p(n) = n^(p+g) sum_k method[p][k] n^(-k) + n^(g-1) sum_k start[p][k] n^(-k).
// At zeta = -exp(-t) A_p has (2^(1+p+k) - 1) zeta(-p-k) in place of zeta(-p-k), and omega starts like t^g:
//   (-1)^n n^(-g-1) sum_k alternating[p][k] n^(-k).
struct StartingWeightEquations::Expansions {
  NumberMatrix method, start, alternating;

  explicit Expansions(const Numbers& all) {
    const NumberVector c = all.at_one(), c_minus = all.alternates() ? all.at_minus_one() : NumberVector{};
    const Number of_start = 1 / tgamma(all.g),
                 of_minus = c_minus.empty() ? Number(0) : Number(1 / tgamma(-all.g));
    for (std::size_t p = 0; p < all.exponents.size(); ++p) {
      const Number power = all.exponents[p];
      const NumberVector zetas = zeta_values(all.exponents[p], all.powers[p], zeta_terms);
      method.push_back(c);
      // c_0 = 1 is the exact integral, which cancels; c_k = 0 for 0 < k < rate, up to rounding.
      for (std::size_t k = 0; k < static_cast<std::size_t>(all.rule.rate); ++k) method[p][k] = 0;
      over_gamma(method[p], all.ratios[p], power + all.g + 1);
      start.push_back(product(c, samples(zetas, Number(0), power == 0)));
      over_gamma(start[p], of_start, all.g);
      if (c_minus.empty()) continue;
      alternating.push_back(product(c_minus, samples(zetas, pow(Number(2), power + 1), power == 0)));
      over_gamma(alternating[p], of_minus, -all.g);
    }
  }

 private:
  // A_p without its singular part. two = 2^(p+1) at zeta = -1, 0 at zeta = 1. Only for p = 0 the sample at j
  // = 0 is not 0.
  static NumberVector samples(const NumberVector& zetas, Number two, bool has_sample_at_zero) {
    NumberVector series(terms, Number(0));
    Number factorial = 1;
    const bool alternates = two != 0;
    for (std::size_t k = 0; k < zeta_terms; ++k) {
      series[k] = (alternates ? Number((two - 1) * zetas[k]) : zetas[k]) / factorial;
      factorial *= -Number(k + 1);
      two *= 2;
    }
    if (has_sample_at_zero) series[0] += 1;
    return series;
  }

  // Multiplies a_k by c / Gamma(z - k), with scale = c / Gamma(z).
  static void over_gamma(NumberVector& a, Number scale, const Number& z) {
    for (std::size_t k = 0; k < a.size(); ++k) {
      a[k] *= scale;
      scale *= z - 1 - k;
    }
  }
};

// x^p for all powers p, x^g and x^(-k) at one x; for a product x from the powers of its factors.
struct StartingWeightEquations::PowersAt {
  NumberVector of_powers, inverse;
  Number of_order;

  PowersAt(const Number& x, const Numbers& all) : inverse(inverse_powers_of(x)) {
    const Number logarithm = log(x);
    for (const double power : all.exponents) of_powers.push_back(exp(Number(power) * logarithm));
    of_order = exp(all.g * logarithm);
  }
  PowersAt(const PowersAt& a, const PowersAt& b) : of_order(a.of_order * b.of_order) {
    for (std::size_t p = 0; p < a.of_powers.size(); ++p) of_powers.push_back(a.of_powers[p] * b.of_powers[p]);
    for (std::size_t k = 0; k < terms; ++k) inverse.push_back(a.inverse[k] * b.inverse[k]);
  }
};

StartingWeightEquations::StartingWeightEquations(const WeightTable& table, const std::vector<double>& powers,
                                                 const std::vector<double>& points)
    : numbers_(std::make_unique<Numbers>(table, powers, near_steps(*table.family->multistep))) {
  numbers_->factors = inverse_of_first(numbers_->powers, powers.size());
  expansions_ = std::make_unique<Expansions>(*numbers_);
  for (const double point : points) points_.emplace_back(Number(point), *numbers_);
}

StartingWeightEquations::~StartingWeightEquations() = default;

StartingWeights::ChebyshevPiece StartingWeightEquations::asymptotic_weights(std::size_t piece) const {
  const auto& all = *numbers_;
  StartingWeights::ChebyshevPiece made{Matrix(std::ssize(points_), std::ssize(all.exponents)), Matrix()};
  if (all.alternates()) made.alternating.resizeLike(made.smooth);
  const PowersAt begin(ldexp(Number(all.near), static_cast<int>(piece)), all);
  for (std::size_t i = 0; i < points_.size(); ++i) {
    const PowersAt x(points_[i], begin);
    const Number at_one = -x.of_order / all.kappa, at_minus_one = -x.inverse[1] / (x.of_order * all.kappa);
    NumberVector e, e_minus;
    for (std::size_t p = 0; p < all.exponents.size(); ++p) {
      e.push_back(at_one * (x.of_powers[p] * in_inverse(expansions_->method[p], x.inverse) +
                            x.inverse[1] * in_inverse(expansions_->start[p], x.inverse)));
      if (all.alternates())
        e_minus.push_back(at_minus_one * in_inverse(expansions_->alternating[p], x.inverse));
    }
    for (std::size_t j = 0; j < all.exponents.size(); ++j) {
      const auto row = static_cast<Eigen::Index>(i), column = static_cast<Eigen::Index>(j);
      made.smooth(row, column) = all.weight(j, e);
      if (all.alternates()) made.alternating(row, column) = all.weight(j, e_minus);
    }
  }
  return made;
}

UsablePowers StartingWeightEquations::usable(const WeightTable& table, const std::vector<double>& powers,
                                             double most) {
  const auto first_steps = std::max<std::size_t>(24, powers.size());
  const Numbers numbers(table, powers, first_steps);
  NumberMatrix moments;
  for (std::size_t p = 0; p < powers.size(); ++p) moments.push_back(numbers.near_moments(p));
  const auto growth = [&](std::size_t count) {
    return numbers.growth(moments, inverse_of_first(numbers.powers, count));
  };
  // The growth increases with each power: bisection for the last usable one.
  UsablePowers last{powers.size(), growth(powers.size())};
  if (last.growth <= most) return last;
  std::size_t unusable = last.count;
  last = {1, growth(1)};
  while (last.count + 1 < unusable) {
    const std::size_t middle = (last.count + unusable) / 2;
    if (const double of_middle = growth(middle); of_middle <= most) {
      last = {middle, of_middle};
    } else {
      unusable = middle;
    }
  }
  return last;
}

}  // namespace fde
