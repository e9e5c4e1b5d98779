// SPDX-License-Identifier: MIT
#include "fdebench/schemes/rules/start_weights/number_series.hpp"

#include <utility>

namespace fde {
namespace {

// B_2i / (2i)! for i = 0, 1, ...: the coefficients of t/2 coth(t/2), a quotient of the series of cosh and
// sinh.
const NumberVector& bernoulli_ratios() {
  static const NumberVector ratios = [] {
    constexpr std::size_t count = 36;
    NumberVector even(count), odd(count), quotient(count);
    Number factorial = 1;
    for (std::size_t i = 0; i < count; ++i) {
      if (i > 0) factorial *= Number(2 * i - 1) * Number(2 * i);
      const Number half = pow(Number(4), -static_cast<int>(i));
      even[i] = half / factorial;
      odd[i] = half / (factorial * (2 * i + 1));
    }
    for (std::size_t i = 0; i < count; ++i) {
      quotient[i] = even[i];
      for (std::size_t k = 1; k <= i; ++k) quotient[i] -= odd[k] * quotient[i - k];
    }
    return quotient;
  }();
  return ratios;
}

}  // namespace

// Only powers of primes are computed; the others are products.
NumberVector integer_powers(double power, std::size_t last) {
  NumberVector values(last + 1, Number(0));
  values[0] = power == 0.0 ? 1 : 0;
  values[1] = 1;
  for (std::size_t j = 2; j <= last; ++j) {
    std::size_t factor = 2;
    while (factor * factor <= j && j % factor != 0) ++factor;
    values[j] = factor * factor > j ? Number(pow(Number(j), Number(power)))
                                    : Number(values[factor] * values[j / factor]);
  }
  return values;
}

NumberVector power_of_series(const NumberVector& a, const Number& exponent) {
  NumberVector b(a.size(), Number(0));
  b[0] = pow(a[0], exponent);
  for (std::size_t n = 1; n < a.size(); ++n) {
    Number sum = 0;
    for (std::size_t k = 1; k <= n; ++k) sum += (exponent * k - (n - k)) * a[k] * b[n - k];
    b[n] = sum / (a[0] * n);
  }
  return b;
}

NumberVector product(const NumberVector& a, const NumberVector& b) {
  NumberVector c(a.size(), Number(0));
  for (std::size_t n = 0; n < c.size(); ++n) {
    for (std::size_t k = 0; k <= n; ++k) c[n] += a[k] * b[n - k];
  }
  return c;
}

NumberVector compose_with_exponential(const NumberVector& p, std::size_t terms) {
  NumberVector series(terms, Number(0));
  for (std::size_t j = 0; j < p.size(); ++j) {
    Number term = p[j];
    for (std::size_t k = 0; k < terms; ++k) {
      series[k] += term;
      term *= -Number(j) / Number(k + 1);
    }
  }
  return series;
}

NumberVector zeta_values(double p, const NumberVector& powers, std::size_t count) {
  constexpr std::size_t from = 32;
  const auto& ratios = bernoulli_ratios();
  NumberVector values, shifted(powers.begin(), powers.begin() + from + 1);
  const Number square = Number(1) / (Number(from) * Number(from));
  if (p == 0.0) shifted[0] = 0;
  for (std::size_t k = 0; k < count; ++k) {
    const Number q = Number(p) + k;
    Number sum = shifted[from] / 2 - shifted[from] * from / (q + 1);
    for (std::size_t j = 1; j < from; ++j) sum += shifted[j];
    Number factor = shifted[from] * (-q) / from;
    for (std::size_t i = 1; i < ratios.size(); ++i) {
      sum += ratios[i] * factor;
      factor *= (2 * i - 1 - q) * (2 * i - q) * square;
    }
    values.push_back(sum);
    for (std::size_t j = 1; j <= from; ++j) shifted[j] *= j;
  }
  return values;
}

NumberMatrix inverse(NumberMatrix a) {
  const std::size_t size = a.size();
  for (std::size_t i = 0; i < size; ++i) {
    a[i].resize(2 * size, Number(0));
    a[i][size + i] = 1;
  }
  for (std::size_t c = 0; c < size; ++c) {
    std::size_t pivot = c;
    for (std::size_t r = c + 1; r < size; ++r) {
      if (abs(a[r][c]) > abs(a[pivot][c])) pivot = r;
    }
    std::swap(a[c], a[pivot]);
    const Number scale = 1 / a[c][c];
    for (auto& entry : a[c]) entry *= scale;
    for (std::size_t r = 0; r < size; ++r) {
      if (r == c || a[r][c] == 0) continue;
      const Number factor = a[r][c];
      for (std::size_t k = c; k < 2 * size; ++k) a[r][k] -= factor * a[c][k];
    }
  }
  for (auto& row : a) row.erase(row.begin(), row.begin() + static_cast<std::ptrdiff_t>(size));
  return a;
}

NumberVector exponential_mean(std::size_t terms) {
  NumberVector mean(terms);
  Number term = 1;
  for (std::size_t k = 0; k < terms; ++k) {
    mean[k] = term;
    term /= -Number(k + 2);
  }
  return mean;
}

}  // namespace fde
