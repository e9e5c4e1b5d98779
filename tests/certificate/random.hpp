// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cmath>
#include <complex>
#include <cstdint>
#include <random>

namespace fde::reference::certificate {

// Random numbers that do not depend on the implementation of the standard library, unlike its distributions.
class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}
  double between(double low, double high) {
    return low + (high - low) * std::ldexp(static_cast<double>(engine_() >> 11U), -53);
  }
  double power_of_ten(double low, double high) { return std::pow(10.0, between(low, high)); }
  double sign() { return between(0.0, 1.0) < 0.5 ? -1.0 : 1.0; }
  bool flip_coin() { return between(0.0, 1.0) < 0.5; }
  double with_random_sign(double x) { return x * sign(); }
  template <std::size_t n>
  double one_of(const std::array<double, n>& values) {
    return values.at(static_cast<std::size_t>(between(0.0, static_cast<double>(n))));
  }

 private:
  std::mt19937_64 engine_;
};

// Braced initialisation evaluates random draws from left to right; the order in a call of std::polar is
// unspecified.
struct Polar {
  double size, turn;
  operator std::complex<double>() const {
    return std::polar(size, turn);
  }  // NOLINT(google-explicit-constructor)
};

}  // namespace fde::reference::certificate
