// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

namespace fde::reference {

// The adjugate of x - A for a matrix A of n rows, and p(x) = det(x - A):
//   (x - A)^-1 = sum_{j<n} x^j N_j / p(x)
// with constant N_j (Faddeev and Le Verrier; Gantmacher, The Theory of Matrices, chapter 4), and bounds of
// their errors. Arithmetic has the types and operations of the numbers:
//   Number, Size (of errors), Entries<T>, Rows<T> (sequences of n^2 and of n objects),
//   number(double), sum(a, b), product(a, b), quotient(a, double), negative(a), size(a) >= |a|,
//   unit(): an upper bound of the error of an operation relative to the sizes of its operands.
template <class Arithmetic>
struct Adjugate {
  using Number = typename Arithmetic::Number;
  using Size = typename Arithmetic::Size;
  template <class T>
  using Entries = typename Arithmetic::template Entries<T>;
  template <class T>
  using Rows = typename Arithmetic::template Rows<T>;

  std::size_t rows = 0;
  Rows<Entries<Number>> parts{};  // N_j row by row
  Rows<Entries<Size>> part_errors{};
  Rows<Number> coefficients{};  // of p by ascending powers, without the leading 1
  Rows<Size> errors{};

  // Precondition: the entries of A row by row, exact.
  Adjugate(std::size_t n, const Entries<Number>& a);
};

// N_{n-1} = I,  p_j = -tr(A N_j) / (n - j),  N_{j-1} = A N_j + p_j.
template <class Arithmetic>
Adjugate<Arithmetic>::Adjugate(std::size_t n, const Entries<Number>& a)
    : rows(n), parts(n), part_errors(n), coefficients(n), errors(n) {
  const auto size = [](const Number& x) { return Arithmetic::size(x); };
  const Size unit = Arithmetic::unit(), none(0.0);
  const Number zero = Arithmetic::number(0.0);
  Entries<Number> part(n * n, zero);
  Entries<Size> sizes(n * n, none), error(n * n, none);
  for (std::size_t i = 0; i < n * n; ++i) sizes[i] = size(a[i]);
  for (std::size_t i = 0; i < n * n; i += n + 1) part[i] = Arithmetic::number(1.0);
  for (std::size_t j = n; j-- > 0;) {
    parts[j] = part;
    part_errors[j] = error;
    Entries<Number> product(n * n, zero);
    Entries<Size> product_error(n * n, none);
    Number trace = zero;
    Size trace_error = none;
    const std::size_t stride = j == 0 ? n + 1 : 1;  // the last product is needed on its diagonal only
    for (std::size_t i = 0; i < n * n; i += stride) {
      for (std::size_t k = 0; k < n; ++k) {
        const std::size_t left = i / n * n + k, right = k * n + i % n;
        if (sizes[left] == none) continue;
        const Size part_size = size(part[right]);
        if (part_size == none && error[right] == none) continue;
        product[i] = Arithmetic::sum(product[i], Arithmetic::product(a[left], part[right]));
        product_error[i] += sizes[left] * (error[right] + unit * part_size);
      }
      if (i % (n + 1) != 0) continue;
      trace = Arithmetic::sum(trace, product[i]);
      trace_error += product_error[i] + unit * size(product[i]);
    }
    const auto by = static_cast<double>(n - j);
    coefficients[j] = Arithmetic::negative(Arithmetic::quotient(trace, by));
    errors[j] = trace_error / by + unit * size(coefficients[j]);
    for (std::size_t i = 0; i < n * n; i += n + 1) {
      product[i] = Arithmetic::sum(product[i], coefficients[j]);
      product_error[i] += errors[j] + unit * size(product[i]);
    }
    part = product;
    error = product_error;
  }
}

}  // namespace fde::reference
