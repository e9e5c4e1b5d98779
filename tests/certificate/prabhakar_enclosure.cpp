// SPDX-License-Identifier: MIT
#include "certificate/prabhakar_enclosure.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "certificate/random.hpp"
#include "fdebench/reference/special_functions/prabhakar_and_matrix/prabhakar.hpp"

namespace fde::reference::certificate {
namespace {

// The power series at the working precision of this thread.
Ball series(const Ball& alpha, const Ball& beta, const Ball& gamma, const Ball& z) {
  constexpr int most_terms = 20'000;
  Ball sum, factor(1.0), last_head;
  double largest = -1e300;
  for (int j = 0; j < most_terms; ++j) {
    const Ball argument = alpha * Ball(j) + beta, head = reciprocal_gamma(argument), term = factor * head;
    sum = sum + term;
    largest = std::max(largest, log2_upper_bound(term));
    const bool small = log2_upper_bound(term) < largest - static_cast<double>(WorkingBits::get());
    if (small && argument - alpha > Ball(0.0) && gamma + Ball(j) > Ball(0.0)) {
      const Ball growth = (gamma + Ball(j)) / Ball(j + 1.0);
      const Ball ratio = abs(z) * (growth > Ball(1.0) ? growth : Ball(1.0)) * head / last_head;
      if (ratio < Ball(0.99)) {
        sum.widen(abs(term) * ratio / (Ball(1.0) - ratio));
        return sum;
      }
    }
    last_head = head;
    factor = factor * z * (gamma + Ball(j)) / Ball(j + 1.0);
  }
  throw std::runtime_error("certificate: the power series does not end");
}

MittagLefflerValue computed(const PrabhakarPoint& x) {
  return x.derivative > 0 ? mittag_leffler_derivative(x.derivative, x.alpha, x.beta, x.z)
                          : prabhakar(x.alpha, x.beta, x.gamma, x.z);
}

}  // namespace

PrabhakarPoint prabhakar_point(int index) {
  Random random(20261122 + static_cast<std::uint64_t>(index));
  const double alpha = random.between(0.2, 2.0);
  const double beta =
      random.one_of(std::array{1.0, alpha, 2.0, 0.5, 1e-12, 1e-30, random.between(-2.0, 4.0)});
  const double size = std::pow(random.power_of_ten(-2.0, std::log10(largest_pole)), alpha);
  const double turn =
      random.flip_coin() ? std::numbers::pi : random.between(-std::numbers::pi, std::numbers::pi);
  const std::complex<double> z = turn == std::numbers::pi ? std::complex(-size) : std::polar(size, turn);
  if (index % 2 == 0) return {alpha, beta, 1.0, z, 1 + static_cast<int>(random.between(0.0, 8.0))};
  return {alpha, beta, random.one_of(std::array{1.0, 2.0, 3.0, 5.0, 9.0, 0.5, 1.5, random.between(0.1, 4.0)}),
          z};
}

Ball prabhakar_enclosure(const PrabhakarPoint& x, int digits) {
  constexpr long most_bits = 4000;
  const long goal = std::lround(digits / std::numbers::ln2 * std::numbers::ln10);
  for (long bits = 2 * goal; bits <= most_bits; bits *= 2) {
    const WorkingBits scope(bits);
    const Ball alpha(x.alpha), k(static_cast<double>(x.derivative));
    const Ball beta = Ball(x.beta) + k * alpha, gamma = x.derivative > 0 ? k + Ball(1.0) : Ball(x.gamma);
    Ball value = series(alpha, beta, gamma, Ball(x.z));
    for (int m = 2; m <= x.derivative; ++m) value = value * Ball(m);
    if (value.accuracy() >= goal) return x.z.imag() == 0.0 ? real(value) : value;
  }
  throw std::runtime_error("certificate: not that many digits of the value within 4000 bits");
}

PrabhakarCheck check_point(const PrabhakarPoint& point) {
  constexpr double allowed = 8.0;
  PrabhakarCheck row{.point = point};
  const Ball value = prabhakar_enclosure(point, 30);
  const auto start = std::chrono::steady_clock::now();
  const auto [stated, bound] = computed(point);
  row.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  const Ball error = abs(Ball(stated) - value), size = abs(value);
  const double ulp = std::ldexp(1.0, std::ilogb(size.mid().real()) - 52);
  row.ulps = error.mid().real() / ulp;
  if (error > Ball(bound)) row.failures.emplace_back("error above the stated bound");
  if (!(bound <= allowed * ulp)) row.failures.emplace_back("the bound is above 8 ulp");
  return row;
}

}  // namespace fde::reference::certificate
