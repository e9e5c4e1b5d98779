// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <random>

namespace fde::bench {

// The numbers of a study. They are computed in 128 bits by MPFR, which rounds each operation correctly, and
// then rounded to double: they are the same on every machine and with every compiler, other than those of
// <cmath> and of the distributions of <random>. A double stands for its shortest decimal: 0.1 is 1/10.

enum class Spacing { linear, logarithmic };

// Number `i` of `count` numbers from `from` to `to`, both among them. Logarithmic spacing needs two numbers
// other than 0 of one sign. Precondition: count > 1.
double spaced_number(double from, double to, int i, int count, Spacing spacing);

// Random numbers from std::mt19937_64, whose output the standard defines.
class NumberSource {
 public:
  explicit NumberSource(std::uint64_t seed) : engine_(seed) {}

  double uniform(double from, double to, Spacing spacing = Spacing::linear);
  double normal(double mean, double deviation);  // by Box and Muller

 private:
  std::mt19937_64 engine_;
};

}  // namespace fde::bench
