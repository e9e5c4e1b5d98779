// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/study/exact_numbers.hpp"

#include <fmt/format.h>
#include <mpfr.h>

namespace fde::bench {
namespace {

constexpr mpfr_prec_t bits = 128;

class Real {
 public:
  Real() { mpfr_init2(value_, bits); }
  explicit Real(double number) : Real() {
    mpfr_set_str(value_, fmt::format("{}", number).c_str(), 10, MPFR_RNDN);
  }
  Real& operator=(Real&&) = delete;
  ~Real() { mpfr_clear(value_); }

  operator mpfr_ptr() {
    return value_;
  }  // NOLINT(google-explicit-constructor): the functions of MPFR take it

 private:
  mpfr_t value_{};
};

// The number at this part of the way from `from` to `to`.
double between(double from, double to, Real& part, Spacing spacing) {
  Real a(from), b(to), rest;
  const bool negative = spacing == Spacing::logarithmic && from < 0.0;
  if (spacing == Spacing::logarithmic) {
    for (mpfr_ptr end : {mpfr_ptr(a), mpfr_ptr(b)}) {
      mpfr_abs(end, end, MPFR_RNDN);
      mpfr_log(end, end, MPFR_RNDN);
    }
  }
  mpfr_ui_sub(rest, 1, part, MPFR_RNDN);
  mpfr_mul(a, a, rest, MPFR_RNDN);
  mpfr_mul(b, b, part, MPFR_RNDN);
  mpfr_add(a, a, b, MPFR_RNDN);
  if (spacing == Spacing::logarithmic) mpfr_exp(a, a, MPFR_RNDN);
  const double size = mpfr_get_d(a, MPFR_RNDN);
  return negative ? -size : size;
}

// Uniform in (0, 1): the middles of 2^53 equal parts.
void set_fraction(Real& fraction, std::mt19937_64& engine) {
  constexpr unsigned unused = 11;
  constexpr mpfr_exp_t part = -54;
  mpfr_set_ui_2exp(fraction, 2 * (engine() >> unused) + 1, part, MPFR_RNDN);
}

}  // namespace

double spaced_number(double from, double to, int i, int count, Spacing spacing) {
  if (i == 0) return from;
  if (i == count - 1) return to;
  Real part;
  mpfr_set_si(part, i, MPFR_RNDN);
  mpfr_div_si(part, part, count - 1, MPFR_RNDN);
  return between(from, to, part, spacing);
}

double NumberSource::uniform(double from, double to, Spacing spacing) {
  Real part;
  set_fraction(part, engine_);
  return between(from, to, part, spacing);
}

double NumberSource::normal(double mean, double deviation) {
  Real radius, angle, centre(mean), scale(deviation);
  set_fraction(radius, engine_);
  set_fraction(angle, engine_);
  mpfr_log(radius, radius, MPFR_RNDN);
  mpfr_mul_si(radius, radius, -2, MPFR_RNDN);
  mpfr_sqrt(radius, radius, MPFR_RNDN);
  Real turn;
  mpfr_const_pi(turn, MPFR_RNDN);
  mpfr_mul_ui(turn, turn, 2, MPFR_RNDN);
  mpfr_mul(angle, angle, turn, MPFR_RNDN);
  mpfr_cos(angle, angle, MPFR_RNDN);
  mpfr_mul(radius, radius, angle, MPFR_RNDN);
  mpfr_fma(radius, radius, scale, centre, MPFR_RNDN);
  return mpfr_get_d(radius, MPFR_RNDN);
}

}  // namespace fde::bench
