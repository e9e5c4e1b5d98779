// SPDX-License-Identifier: MIT
#include "fdebench/reference/special_functions/prabhakar_and_matrix/prabhakar_transform.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "fdebench/reference/special_functions/numbers/reciprocal_gamma.hpp"
#include "fdebench/reference/special_functions/prabhakar_and_matrix/prabhakar_shape.hpp"
#include "fdebench/schemes/problem/progress/progress.hpp"

namespace fde::reference {

namespace {

using Long = long double;
using Point = EnclosingContour::Point;
using Node = EnclosingContour::Node;

constexpr Long half_turn = std::numbers::pi_v<Long>;

Point long_point(const BigComplex& s) {
  return {real_part<BigReal>(s).convert_to<Long>(), imag_part<BigReal>(s).convert_to<Long>()};
}

// The logarithm of 1 - z s^-alpha with cuts from the s* to the left. The principal logarithm has its cuts
// from 0 to the s* instead: between these and the negative axis it differs by 2 pi i. (Only for omitted s*
// does the contour have points there.)
BigComplex log_with_cuts_to_the_left(const PrabhakarSingularities& x, const Point& s,
                                     const BigComplex& argument) {
  BigComplex value = log(argument);
  const Long height = std::abs(s.imag()), angle = std::arg(s);
  for (std::size_t k = 0; k < x.roots.size(); ++k) {
    const Long root_angle = x.log_roots[k].imag(), sign = root_angle > 0.0L ? 1.0L : -1.0L;
    if (sign * s.imag() <= 0.0L || height >= std::abs(x.roots[k].imag())) continue;
    const Long beyond = sign * x.alpha * (angle - root_angle);
    constexpr Long unsure = 0.1L;  // near its cut the imaginary part of the logarithm decides
    const bool crossed = std::abs(beyond) < unsure ? sign * imag_part<BigReal>(value) > 0 : beyond > 0.0L;
    if (crossed) value -= BigComplex(BigReal(0), BigReal(2 * sign * pi<BigReal>()));
  }
  return value;
}

// Evaluation of F at the nodes, at one precision.
class Evaluation {
 public:
  Evaluation(const PrabhakarArguments& x, const PrabhakarSingularities& shape)
      : x_(x), shape_(shape), power_(shape.power_of(x)), log_z_(log(x.z)) {
    for (const auto& root : shape.log_roots) {
      const auto turns = std::round((shape.alpha * root.imag() - shape.log_z.imag()) / (2.0L * half_turn));
      const BigComplex turned = log_z_ + BigComplex(BigReal(0), BigReal(2 * turns * pi<BigReal>()));
      roots_.push_back(x.alpha == 1 ? x.z : exp(BigComplex(turned / x.alpha)));
    }
  }

  void add(const Node& node, std::vector<BoundedSum<BigReal>>& sums) const {
    sums.resize(1);
    BigReal ulps = 8 + 4 * norm1(node.s);
    const BigComplex value = shape_.integer_alpha              ? by_roots(node, ulps)
                             : shape_.subtracts_leading_term() ? without_head(node, ulps)
                                                               : by_logarithm(node, ulps);
    sums.front().add(BigComplex(node.weight * value), BigReal(ulps * epsilon<BigReal>()));
  }

 private:
  // For integer alpha: F = s^(alpha gamma - beta) product of (s - s*)^-gamma.
  BigComplex by_roots(const Node& node, BigReal& ulps) const {
    BigComplex exponent = power_ * node.log_s;
    const BigReal root_ulps = 2 + 2 * norm1(log_z_);
    for (const auto& root : roots_) {
      const BigComplex difference = node.s - root, logarithm = log(difference);
      exponent -= x_.gamma * logarithm;
      const BigReal loss = (norm1(node.s) + root_ulps * norm1(root)) / norm1(difference);
      ulps += abs(x_.gamma) * (4 + 2 * norm1(logarithm) + 2 * loss);
    }
    ulps += 4 * abs(power_) * (1 + norm1(node.log_s));
    return exp(exponent);
  }

  // F = s^-beta (1 - z s^-alpha)^-gamma.
  BigComplex by_logarithm(const Node& node, BigReal& ulps) const {
    const BigComplex ratio = exp(BigComplex(log_z_ - x_.alpha * node.log_s)), factor = 1 - ratio;
    const BigComplex logarithm = log_with_cuts_to_the_left(shape_, long_point(node.s), factor);
    const BigReal ratio_ulps = 4 + 4 * (norm1(log_z_) + x_.alpha * norm1(node.log_s));
    ulps += abs(x_.gamma) * (4 + 2 * norm1(logarithm) + 2 * ratio_ulps * norm1(ratio) / norm1(factor));
    ulps += 4 * abs(x_.beta) * (1 + norm1(node.log_s));
    return exp(BigComplex(-x_.beta * node.log_s - x_.gamma * logarithm));
  }

  // F - (-z)^-gamma s^power = (-z)^-gamma s^power ((1 - s^alpha / z)^-gamma - 1): power is an integer >= 0,
  // so that the subtracted term contributes nothing.
  BigComplex without_head(const Node& node, BigReal& ulps) const {
    const BigComplex ratio = exp(BigComplex(x_.alpha * node.log_s - log_z_));
    BigComplex power = -x_.gamma * log_of_one_minus(ratio);
    ulps += 16 + 8 * (norm1(log_z_) + x_.alpha * norm1(node.log_s)) + 4 * abs(x_.gamma);
    ulps += 4 * (power_ + abs(x_.gamma)) * (1 + norm1(node.log_s) + norm1(log_z_));
    const BigComplex head = power_ * node.log_s - x_.gamma * log(BigComplex(-x_.z));
    return exp(head) * exponential_less_one(power);
  }

  // log(1 - x) = -2 artanh(y) = -2 sum y^(2k+1) / (2k+1), y = x / (2 - x), and e^x - 1 by its series, for
  // small |x|.
  static BigComplex log_of_one_minus(const BigComplex& x) {
    const BigComplex y = x / (2 - x), square = y * y;
    BigComplex sum(0), power = y;
    for (int k = 1; norm1(power) > epsilon<BigReal>() * norm1(sum); k += 2, power *= square)
      sum += power / BigReal(k);
    return -2 * sum;
  }
  static BigComplex exponential_less_one(const BigComplex& x) {
    if (norm1(x) > 0.5) return exp(x) - BigReal(1);
    BigComplex sum(0), term = x;
    for (int k = 2; norm1(term) > epsilon<BigReal>() * norm1(sum); ++k) {
      sum += term;
      term *= x / BigReal(k);
    }
    return sum;
  }

  PrabhakarArguments x_;
  PrabhakarSingularities shape_;
  BigReal power_;
  BigComplex log_z_;
  std::vector<BigComplex> roots_;
};

// A bound of the sum of the terms after the k-th, infinite where there is none yet; next is
// (gamma)_{k+1} z^{k+1} / (k+1)!. From there on |(gamma + k) / (k + 1)| is at most its value there, or 1. And
//   Gamma(x + alpha) / Gamma(x) >= (x - 1)^alpha, for psi(x) >= log x - 1/x >= log(x - 1);
//   1/Gamma(x) <= 1.13, x >= 0.
BigReal tail(const PrabhakarArguments& x, int k, const BigComplex& next) {
  const BigReal argument = x.alpha * (k + 1) + x.beta, growing = x.gamma + k + 1;
  const BigReal power = abs(x.z) * std::max(BigReal(1), BigReal(abs(growing) / (k + 2)));
  const BigReal ratio = argument < 2 ? power : BigReal(power * pow(BigReal(argument - 1), -x.alpha));
  if (argument < 0 || growing <= 0 || ratio > 0.9) return {std::numeric_limits<double>::infinity()};
  constexpr double upwards = 1.01;
  const BigReal first = argument < 2
                            ? BigReal(1.13)
                            : BigReal(upwards * exp(BigReal(-log_gamma(argument.convert_to<double>()))));
  return norm1(next) * first / (1 - ratio);
}

}  // namespace

EnclosedTransform prabhakar_transform(const ReadPrabhakar& read) {
  constexpr int enough_digits = 120;
  const Precision precision(enough_digits);
  const PrabhakarArguments x = read();
  const PrabhakarSingularities shape(x);
  EnclosedTransform transform{
      .singularities = shape.roots,
      .hints = {.order = std::abs(shape.gamma),
                .growth = std::abs(shape.beta) + std::abs(shape.gamma) * (1.0L + shape.alpha)},
      .real = x.real()};
  if (!shape.has_no_cut()) transform.singularities.emplace_back(0.0L);
  keep_right_of_saddle_point(transform, shape.beta);
  transform.zero_digits += static_cast<int>(2.0L * std::abs(shape.beta));
  transform.prepare = [read, shape] {
    return EnclosedTransform::Evaluation{
        .add = [evaluation = Evaluation(read(), shape)](const Node& node, EnclosedTransform::Sums& sums) {
          evaluation.add(node, sums);
        }};
  };
  transform.majorants = {[shape](const EnclosingContour::Disc& disc) { return shape.log_majorant(disc); }};
  return transform;
}

BoundedSum<BigReal> prabhakar_series(const PrabhakarArguments& x) {
  constexpr int most_terms = 200000;
  BoundedSum<BigReal> sum;
  BigComplex factor(1);  // (gamma)_k z^k / k!
  BigReal factor_ulps(0);
  for (int k = 0; k < most_terms; ++k) {
    report_progress(static_cast<std::size_t>(k));
    // for derivatives, x.beta is itself a sum beta + (gamma - 1) alpha
    const BigReal argument = x.alpha * k + x.beta, size = x.alpha * (k + 2 * abs(x.gamma)) + abs(x.beta);
    const BigReal ulps = factor_ulps + abs(argument) * (2 + 2 * log1p(abs(argument)));
    add_reciprocal_gamma(sum, factor, argument, size, ulps);
    // As for the arguments of Gamma, gamma + k within rounding of 0 is 0.
    const BigReal growing = x.gamma + k, rounding = 2 * (abs(x.gamma) + k);
    if (abs(growing) <= rounding * epsilon<BigReal>() || x.z == 0) return sum;
    factor *= x.z * growing / BigReal(k + 1);
    factor_ulps += 6 + rounding / abs(growing);
    const BigReal rest = tail(x, k, factor);
    if (rest > epsilon<BigReal>() * norm1(sum.value)) continue;
    sum.error += rest;
    return sum;
  }
  throw std::runtime_error(fmt::format("the power series takes more than {} terms", most_terms));
}

}  // namespace fde::reference
