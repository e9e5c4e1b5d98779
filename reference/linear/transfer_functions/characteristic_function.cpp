// SPDX-License-Identifier: MIT
#include "fdebench/reference/linear/transfer_functions/characteristic_function.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "fdebench/reference/special_functions/numbers/constants.hpp"
#include "fdebench/schemes/problem/progress/progress.hpp"

namespace fde::reference {

namespace {

using Point = CharacteristicFunction::Point;

// Enough digits for the cancellation of terms of close orders: a gap of 10^-n between two orders takes n.
int most_digits_for(const std::vector<ExponentialPolynomial<long double>::Term>& terms) {
  constexpr long double least = 40.0L, most = 400.0L;
  long double digits = least;
  for (std::size_t i = 1; i < terms.size(); ++i)
    digits += std::max(0.0L, -std::log10(terms[i].order - terms[i - 1].order));
  return static_cast<int>(std::min(digits, most));
}

template <class Real>
ExponentialPolynomial<Real> rounded_characteristic(const GeneralizedPolynomial& exact) {
  ExponentialPolynomial<Real> result;
  for (const auto& [order, coefficient] : exact)
    result.terms.push_back({log(Complex<Real>(rounded<Real>(coefficient).value)), rounded<Real>(order)});
  return result;
}

template <class Real>
Point long_point(const Complex<Real>& z) {
  return {static_cast<long double>(real_part<Real>(z)), static_cast<long double>(imag_part<Real>(z))};
}

// Upper bounds of |e^x - 1|, and of the remainder of the series of e^x after the first `terms` terms.
long double exp_minus_one_bound(const Point& x) {
  const long double size = std::abs(x);
  return x.real() > 0.0L ? size * std::exp(x.real()) : std::min(size, 2.0L);
}
long double exp_remainder_bound(const Point& x, std::size_t terms) {
  long double rest = std::exp(std::max(0.0L, x.real()));
  for (std::size_t k = 1; k <= terms; ++k) rest *= std::abs(x) / static_cast<long double>(k);
  return rest;
}

constexpr long double clear = 1e3L;  // in units of the noise: a few digits are correct

// Change of arg P on the straight path from a to b; nullopt unless |P| is shown to stay away from 0, where
// arg P changes by order Im(b - a) plus less than pi/4. For large |w|, where one term or terms of nearly the
// same order dominate, the path may have any length. The values at a and b do not suffice: next to two close
// zeros, arg P turns twice by nearly pi.
std::optional<long double> argument_change_on_segment(const CharacteristicFunction& function, const Point& a,
                                                      const Point& b) {
  const auto [at_a, order, change] = function.path_bound(a, b);
  if (!(change < 0.7L * std::abs(at_a))) return std::nullopt;
  const Point at_b = function.scaled_value(b).value;
  const long double turned = order * (b - a).imag();
  return turned + std::arg(at_b * std::conj(at_a) * std::polar(1.0L, -turned));
}

// Change of arg P from a to b, by bisection; nullopt where a zero is on the path up to rounding.
std::optional<long double> argument_change(const CharacteristicFunction& function, const Point& a,
                                           const Point& b) {
  constexpr long double shortest = 1e-11L;
  if (const auto there = argument_change_on_segment(function, a, b)) return there;
  if (const auto back = argument_change_on_segment(function, b, a)) return -*back;
  const Point middle = (a + b) / 2.0L;
  const auto [at_middle, noise, digits] = function.scaled_value(middle);
  if (std::abs(b - a) < shortest || middle == a || middle == b || std::abs(at_middle) < 2.0L * noise)
    return std::nullopt;
  const auto first = argument_change(function, a, middle);
  const auto second = first ? argument_change(function, middle, b) : std::nullopt;
  return second ? std::optional(*first + *second) : std::nullopt;
}

}  // namespace

CharacteristicFunction::CharacteristicFunction(const LinearTransform& exact)
    : exact_(exact.characteristic),
      rounded_(rounded_characteristic<long double>(exact_)),
      most_digits_(most_digits_for(rounded_.terms)) {
  for (const auto& term : rounded_.terms)
    largest_log_ = std::max(largest_log_, std::abs(term.log_coefficient));
}

template <class Real>
CharacteristicFunction::Moments CharacteristicFunction::moments(
    const ExponentialPolynomial<Real>& characteristic, const Point& w, const MomentSelection& chosen) {
  const auto terms = characteristic.scaled_terms(Complex<Real>(Real(w.real()), Real(w.imag())));
  const Real origin = chosen.origin ? characteristic.terms[*chosen.origin].order : Real(0);
  std::vector<Complex<Real>> sums(chosen.count, Complex<Real>(0));
  for (std::size_t i = 0; i < terms.size(); ++i) {
    if (!chosen.terms.empty() && !chosen.terms[i]) continue;
    const Real distance = characteristic.terms[i].order - origin;
    Complex<Real> power = terms[i];
    for (auto& sum : sums) {
      sum += power;
      power *= distance;
    }
  }
  Moments result{};
  std::ranges::transform(sums, result.begin(), long_point<Real>);
  return result;
}

CharacteristicFunction::Moments CharacteristicFunction::moments(int digits, const Point& w,
                                                                const MomentSelection& chosen) const {
  if (digits == 0) return moments(rounded_, w, chosen);
  report_progress(0);
  const Precision precision(digits);
  auto known = precise_.find(digits);
  if (known == precise_.end())
    known = precise_.emplace(digits, rounded_characteristic<BigReal>(exact_)).first;
  return moments(known->second, w, chosen);
}

long double CharacteristicFunction::noise_at(const Point& w, int digits) const {
  const long double unit =
      digits == 0 ? epsilon<long double>() : std::pow(10.0L, -static_cast<long double>(digits));
  return unit * (2.0L + 2.0L * (largest_log_ + rounded_.terms.back().order * std::abs(w)));
}

// The digits suffice if a zero is determined well (noise over slope is small), or if a cluster of zeros is
// established, or if value and slope have a few correct digits.
CharacteristicFunction::Derivatives CharacteristicFunction::derivatives(const Point& w) const {
  constexpr long double known_well = 1e-9L;
  long double size = 0.0L, slopes = 0.0L, bends = 0.0L;
  const auto scaled = rounded_.scaled_terms(w);
  for (std::size_t i = 0; i < scaled.size(); ++i) {
    const long double order = rounded_.terms[i].order, modulus = std::abs(scaled[i]);
    size += modulus;
    slopes += order * modulus;
    bends += order * order * modulus;
  }
  for (int digits = 0;; digits = next_digits(digits)) {
    const Moments sums = moments(digits, w, {.count = 3});
    const long double noise = noise_at(w, digits), value = std::abs(sums[0]), slope = std::abs(sums[1]);
    const Derivatives known{sums[0] / size, sums[1] / size, sums[2] / size, noise};
    const bool well = known_well * slope > noise * size, left = value > clear * noise * size,
               left_of_slope = slope > clear * noise * slopes,
               several = std::abs(sums[2]) > clear * noise * bends && known.is_near_multiple_zero();
    if (well || several || (left && left_of_slope) || digits == most_digits_) return known;
  }
}

CharacteristicFunction::ScaledValue CharacteristicFunction::scaled_value(const Point& w) const {
  for (int digits = 0;; digits = next_digits(digits)) {
    const ScaledValue known{moments(digits, w, {})[0], noise_at(w, digits), digits};
    if (std::abs(known.value) > clear * known.noise || digits == most_digits_) return known;
  }
}

// By the series of e^(d (b-a)) for orders at a small distance d from the order of the largest term, whose
// terms may cancel; the other terms are bounded by their moduli.
CharacteristicFunction::PathBound CharacteristicFunction::path_bound(const Point& a, const Point& b) const {
  constexpr long double near = 0.5L;
  const auto sizes = rounded_.log_sizes(a);
  const auto largest = static_cast<std::size_t>(std::ranges::max_element(sizes) - sizes.begin());
  const long double order = rounded_.terms[largest].order;
  const auto [start, noise, digits] = scaled_value(a);
  MomentSelection chosen{.count = most_moments, .origin = largest};
  PathBound way{start, order, 0.0L};
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    const Point exponent = (rounded_.terms[i].order - order) * (b - a);
    const bool is_near = std::abs(exponent) < near;
    chosen.terms.push_back(is_near);
    const long double off = is_near ? exp_remainder_bound(exponent, most_moments) + noise * std::abs(exponent)
                                    : exp_minus_one_bound(exponent);
    way.change += std::exp(sizes[i] - sizes[largest]) * off;
  }
  const Moments sums = moments(digits, a, chosen);
  long double power = 1.0L;
  for (std::size_t k = 1; k < most_moments; ++k) {
    power *= std::abs(b - a) / static_cast<long double>(k);
    way.change += std::abs(sums[k]) * power;
  }
  return way;
}

std::optional<int> count_zeros(const CharacteristicFunction& function, const Rectangle& box) {
  const std::array<Point, 4> corners{Point(box.left, -box.height), Point(box.right, -box.height),
                                     Point(box.right, box.height), Point(box.left, box.height)};
  long double total = 0.0L;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Point &a = corners[i], &b = corners[(i + 1) % corners.size()];
    const auto angle = argument_change(function, a, b);
    if (!angle) return std::nullopt;
    total += *angle;
  }
  return static_cast<int>(std::lround(total / (2.0L * pi_long)));
}

}  // namespace fde::reference
