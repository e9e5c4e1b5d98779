// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "fdebench/reference/special_functions/numbers/real.hpp"
#include "fdebench/schemes/problem/interval.hpp"

namespace fde::bench {

// How a function continues between its samples: with the value of the last one at or before the argument; on
// the line through both neighbours; or as the cubic spline with continuous second derivative and the
// not-a-knot condition, that is with a continuous third derivative at the second sample and the last but one
// (de Boor, A Practical Guide to Splines, 1978, chapter IV).
enum class Interpolation { constant, linear, cubic };

// A piecewise polynomial through samples, or a derivative of one, on [first(), last()]. Samples are the
// decimals that their doubles print; so are the second derivatives of a spline at its samples, which are
// rounded to doubles: in every Real the function is the same one.
class SampledFunction {
 public:
  using Pointer = std::shared_ptr<const SampledFunction>;

  static constexpr std::size_t fewest(Interpolation between) {
    return between == Interpolation::cubic ? 4 : 2;
  }

  // `name`: of the function in formulas; `source`: of its samples in messages. Preconditions: as many
  // arguments as values, at least fewest(between), all finite, the arguments strictly increasing.
  static Pointer through(std::string name, std::string source, Interpolation between,
                         std::vector<double> arguments, std::vector<double> values);

  [[nodiscard]] const std::string& name() const { return name_; }
  [[nodiscard]] const std::string& source() const { return source_; }
  [[nodiscard]] const std::vector<double>& arguments() const { return *arguments_; }
  [[nodiscard]] const std::vector<double>& values() const { return *values_; }
  [[nodiscard]] double first() const { return arguments_->front(); }
  [[nodiscard]] double last() const { return arguments_->back(); }

  // The value; NaN outside of the samples, except within `margin` of them, where the first or the last
  // polynomial goes on: an argument that is computed, or taken just beside a jump, may be there.
  [[nodiscard]] double at(double x) const;
  // An interval that contains the values at all x that are inside; all real numbers where none is.
  [[nodiscard]] Interval at(const Interval& x) const;
  template <class Real>
  [[nodiscard]] Real at(const Real& x) const;
  [[nodiscard]] double margin() const;
  // The value, and the size of which its rounding error is a few units: the sum of the absolute terms of the
  // polynomial and of those that its coefficients are sums of.
  template <class Real>
  [[nodiscard]] std::pair<Real, Real> at_with_size(const Real& x) const;

  // nullptr where it is 0 between all samples.
  [[nodiscard]] const Pointer& derivative() const { return derivative_; }

  // The smallest k for which the k-th derivative jumps at samples: 0 if it jumps itself, 1 if it has kinks.
  [[nodiscard]] int jumping_derivative() const { return degree(); }
  // The samples at which that derivative jumps, increasing.
  [[nodiscard]] const std::vector<double>& breaks() const { return *breaks_; }
  // Whether no derivative jumps at x.
  [[nodiscard]] bool is_smooth_at(double x) const;
  // A function with the same breaks that changes its sign at each of these, and nowhere else.
  [[nodiscard]] Pointer alternation() const;

  // The polynomials by increasing argument: where each begins, and its Taylor coefficients there, by
  // increasing power, computed from number(x) for each double x of the samples.
  [[nodiscard]] std::size_t pieces() const;
  [[nodiscard]] double start(std::size_t piece) const { return (*arguments_)[piece]; }
  template <class Number>
  [[nodiscard]] auto coefficients(std::size_t piece, const Number& number) const;

 private:
  using Shared = std::shared_ptr<const std::vector<double>>;

  SampledFunction() = default;
  static Pointer derivative_of(const SampledFunction& function);
  void tabulate();
  void find_breaks();
  [[nodiscard]] int degree() const;
  [[nodiscard]] std::size_t piece_at(double x) const;
  // The coefficients in double.
  [[nodiscard]] std::span<const double> tabulated(std::size_t piece) const;
  [[nodiscard]] bool contains(double x) const;
  [[nodiscard]] double coefficient_size(std::size_t piece) const;
  [[nodiscard]] Interval range_on(std::size_t piece, const Interval& x) const;

  std::string name_{}, source_{};
  Interpolation between_ = Interpolation::linear;
  int order_ = 0;  // of the derivative that this is
  Shared arguments_{}, values_{}, curvatures_{}, breaks_{};
  std::vector<double> coefficients_{};
  Pointer derivative_{};
};

template <class Number>
auto SampledFunction::coefficients(std::size_t piece, const Number& number) const {
  using Value = decltype(number(0.0));
  const auto of = [&](const Shared& samples, std::size_t i) { return number((*samples)[i]); };
  const Value u = of(values_, piece);
  std::vector<Value> taylor{u};
  if (between_ != Interpolation::constant) {
    const Value h = of(arguments_, piece + 1) - of(arguments_, piece);
    taylor.push_back((of(values_, piece + 1) - u) / h);
    if (between_ == Interpolation::cubic) {
      const Value here = of(curvatures_, piece), next = of(curvatures_, piece + 1), six = number(6.0);
      taylor.back() = taylor.back() - h * (here + here + next) / six;
      taylor.push_back(here / number(2.0));
      taylor.push_back((next - here) / (six * h));
    }
  }
  for (int k = 0; k < order_; ++k) {
    taylor.erase(taylor.begin());
    for (std::size_t power = 1; power < taylor.size(); ++power)
      taylor[power] = number(static_cast<double>(power + 1)) * taylor[power];
  }
  return taylor;
}

template <class Real>
Real SampledFunction::at(const Real& x) const {
  return at_with_size(x).first;
}

template <class Real>
std::pair<Real, Real> SampledFunction::at_with_size(const Real& x) const {
  using std::abs;
  using Decimal = std::conditional_t<std::is_floating_point_v<Real>, long double, Real>;
  const auto number = [](double sample) { return Real(reference::from_shortest_decimal<Decimal>(sample)); };
  const auto nearest = static_cast<double>(x);
  const Real nan = std::numeric_limits<Real>::quiet_NaN();
  if (!contains(nearest)) return {nan, nan};
  std::size_t piece = piece_at(nearest);
  if (piece > 0 && x < number(start(piece))) --piece;
  if (piece + 1 < pieces() && !(x < number(start(piece + 1)))) ++piece;
  const Real offset = x - number(start(piece));
  const auto taylor = coefficients(piece, number);
  Real value = taylor.back(), size = abs(taylor.back());
  for (std::size_t k = taylor.size() - 1; k-- > 0;) {
    value = Real(value * offset + taylor[k]);
    size = Real(size * abs(offset) + abs(taylor[k]));
  }
  return {value, Real(size + coefficient_size(piece))};
}

}  // namespace fde::bench
