#include "mittag_leffler/quick.hpp"

#include <algorithm>
#include <boost/container/static_vector.hpp>
#include <cmath>

#include "laplace/contour_bound.hpp"
#include "mittag_leffler/contour_kernels.hpp"

namespace fde {
namespace {

using Value = std::complex<long double>;
constexpr long double pi_long = std::numbers::pi_v<long double>;
constexpr double pi_double = std::numbers::pi;
// Of a few operations in long double.
constexpr long double few_ulps = 16.0L * std::numeric_limits<long double>::epsilon();

// A contour with its nodes half a step apart from those of its twin, and the exponents it is meant for.
struct QuickContour {
  explicit QuickContour(const ContourShape& of)
      : shape(of), bound(of), half_log_mu(make_half_log(of.mu)), nodes(make_nodes(of)) {}

  static constexpr int digits = 45;
  static DoubleDouble make_half_log(double mu) {
    const Precision precision(digits);
    return to_double_double(log(BigReal(mu)) / 2);
  }
  static ContourNodes make_nodes(const ContourShape& shape) {
    const Precision precision(digits);
    return ContourNodes(Contour<BigReal>(shape.mu, shape.omega, shape.depth, shape.half_step_shift));
  }

  ContourShape shape;
  ContourBound bound;
  DoubleDouble half_log_mu;
  ContourNodes nodes;
};

struct QuickContours {
  double least_exponent, most_exponent;  // of s for small s, and for large s
  std::array<QuickContour, 2> twins;

  [[nodiscard]] bool fit(double least, double most) const {
    return least >= least_exponent && most <= most_exponent;
  }
};

// mu near -exponent keeps the terms as small as 1/Gamma(-exponent), a large depth waits for s^exponent e^s to
// fall off. The last one has terms of the size of the value and three times as many: rounding there is least.
const std::array<QuickContours, 6>& all_contours() {
  const auto both = [](double mu, double omega, double depth) {
    return std::array{QuickContour({mu, omega, depth, false}), QuickContour({mu, omega, depth, true})};
  };
  static const std::array<QuickContours, 6> all{{{-2.5, 2.5, both(6.0, 52.0, 43.5)},
                                                 {-3.0, 3.0, both(7.0, 64.0, 60.0)},
                                                 {-3.0, 25.0, both(7.0, 64.0, 140.0)},
                                                 {-25.0, 10.0, both(16.0, 128.0, 70.0)},
                                                 {-60.0, 20.0, both(32.0, 256.0, 90.0)},
                                                 {-4.0, 25.0, both(2.0, 96.0, 140.0)}}};
  return all;
}

// 1/Gamma(x), with the distance from a pole of Gamma to all its digits.
long double reciprocal_gamma_of(const DoubleDouble& x) {
  const long double value = static_cast<long double>(x.hi) + x.lo;
  if (value > 0.5L) return 1.0L / std::tgamma(value);
  const double whole = std::round(x.hi);
  const long double beyond = static_cast<long double>(x.hi - whole) + x.lo;
  const long double sign = std::fmod(whole, 2.0) == 0.0 ? 1.0L : -1.0L;
  return sign * std::sin(pi_long * beyond) * std::tgamma(1.0L - value) / pi_long;
}

// z = scaled * 2^exponent with 1 <= |scaled| < 4; |z| may be as small or large as a double can be.
struct Scaled {
  std::complex<double> value;
  int exponent;
  ComplexDoubleDouble log;  // of z

  explicit Scaled(std::complex<double> z)
      : exponent(std::ilogb(std::max(std::abs(z.real()), std::abs(z.imag())))) {
    value = {std::scalbn(z.real(), -exponent), std::scalbn(z.imag(), -exponent)};
    log = complex_logarithm(value);
    const DoubleDouble head = exact_product(exponent, ln2.hi), tail{exponent * ln2.lo, 0.0};
    log.re = log.re + head + tail;
  }
};

// A pole s*^alpha = z with the logarithm of s* in double.
struct Pole {
  double sheet;
  std::complex<double> log;
  bool paired;  // stands for its conjugate as well
};

constexpr int most_sheet = 6;
template <class T>
using EachSheet = boost::container::static_vector<T, 2 * most_sheet + 1>;

struct Arguments {
  double alpha;
  DoubleDouble beta;
  std::complex<double> z;
  Scaled scaled{z};
  EachSheet<Pole> poles{};  // |arg s*| < 2 pi; for real z one of each conjugate pair
  double nearest_sheet = std::numeric_limits<double>::infinity();  // of the other poles, as in ContourBound

  [[nodiscard]] bool real() const { return z.imag() == 0.0; }
  // All powers of s in the transform are whole: no branch cut, and the poles are everything.
  [[nodiscard]] bool cut_free() const {
    return std::floor(alpha) == alpha && std::floor(beta.hi) == beta.hi && beta.lo == 0.0 && beta.hi <= alpha;
  }
};

Arguments arguments_of(double alpha, const DoubleDouble& beta, std::complex<double> z) {
  constexpr double most_log = 600.0, most_log_of_contour = 20.0;
  Arguments x{.alpha = alpha, .beta = beta, .z = z};
  const double log_size = x.scaled.log.re.hi;
  for (int sheet = x.real() ? 0 : -most_sheet; sheet <= most_sheet; ++sheet) {
    const double argument = x.scaled.log.im.hi + 2.0 * sheet * pi_double;
    const int half_turns = 2 * sheet + (z.real() < 0.0 ? 1 : 0);  // of z, if it is real
    if (log_size / alpha < -most_log) {                           // next to 0
      x.nearest_sheet = std::min(x.nearest_sheet, -log_size - most_log_of_contour * alpha);
    } else if (std::abs(argument) < 2.0 * pi_double * alpha) {
      x.poles.push_back({.sheet = static_cast<double>(sheet),
                         .log = std::complex(log_size, argument) / alpha,
                         .paired = x.real() && half_turns != 0 && half_turns != alpha});
    } else {
      x.nearest_sheet = std::min(x.nearest_sheet, std::abs(argument));
    }
  }
  return x;
}

QuickValue operator+(const QuickValue& a, const QuickValue& b) {
  return {a.value + b.value, a.error + b.error};
}

long double size_of(const Value& z) { return std::abs(z.real()) + std::abs(z.imag()); }

Value to_long(const ComplexDoubleDouble& z) {
  return {static_cast<long double>(z.re.hi) + z.re.lo, static_cast<long double>(z.im.hi) + z.im.lo};
}

// Head of the asymptotic expansion, exact with what is left for every count:
//   E_{alpha,beta}(z) = -sum_{k=1}^m z^-k / Gamma(beta - alpha k) + z^-m E_{alpha,beta-m alpha}(z).
QuickValue head(const Arguments& x, int count) {
  const Value inverse = 1.0L / Value(x.z);
  QuickValue sum{0.0L, 0.0L};
  Value power = 1.0L;
  for (int k = 1; k <= count; ++k) {
    power *= inverse;
    const DoubleDouble argument = x.beta + exact_product(-k, x.alpha);
    const Value term = -power * reciprocal_gamma_of(argument);
    sum = sum + QuickValue{term, few_ulps * size_of(term)};
  }
  return sum;
}

QuickValue contour_sum(const Arguments& x, const QuickContour& contour, const DoubleDouble& exponent,
                       int peeled) {
  const double scale = std::scalbn(1.0, -std::max(x.scaled.exponent, 0));
  const std::complex<double> scaled = scale == 1.0 ? x.z : x.scaled.value;
  const QuotientSum sum = sum_over_nodes(contour.nodes, {x.alpha, exponent, scaled, scale});
  Value factor = scale;
  for (int k = 0; k < peeled; ++k) factor /= Value(x.z);
  const Value value = factor * to_long(sum.value);
  return {value, few_ulps * size_of(value) + size_of(factor) * sum.error};
}

// The poles that have to be corrected for; empty where the phase of a large one is not to be had.
std::optional<EachSheet<Pole>> within_reach(const EachSheet<Pole>& counted) {
  constexpr double most_log = 26.0, clear = 1e-7;
  EachSheet<Pole> poles;
  for (const Pole& pole : counted) {
    if (pole.log.real() < most_log) {
      poles.push_back(pole);
    } else if (std::cos(pole.log.imag()) > -clear) {  // otherwise e^s* is nothing
      return std::nullopt;
    }
  }
  return poles;
}

// Sum of the residues, scaled by the largest exponent while they are added.
QuickValue residue_sum(const Arguments& x, const PoleArguments& arguments, const EachSheet<Pole>& poles) {
  EachSheet<Residue> residues;
  for (std::size_t first = 0; first < poles.size(); first += double_double_lanes) {
    const std::size_t count = std::min(poles.size() - first, double_double_lanes);
    std::array<double, double_double_lanes> sheets{};
    sheets.fill(poles[first].sheet);
    for (std::size_t i = 0; i < count; ++i) sheets[i] = poles[first + i].sheet;
    const Residues some = residues_at(arguments, sheets, count);
    residues.insert(residues.end(), some.begin(), some.begin() + static_cast<std::ptrdiff_t>(count));
  }
  double largest = -std::numeric_limits<double>::infinity();
  for (const auto& residue : residues) largest = std::max(largest, residue.exponent);
  QuickValue sum{0.0L, 0.0L};
  for (std::size_t i = 0; i < residues.size(); ++i) {
    const auto below = static_cast<int>(std::max(residues[i].exponent - largest, -20000.0));
    const long double scale = std::ldexp(poles[i].paired ? 2.0L : 1.0L, below);
    Value value = scale * to_long(residues[i].value);
    const long double error = size_of(value) * residues[i].relative_error;
    if (x.real()) value = value.real();
    sum = sum + QuickValue{value, error + few_ulps * size_of(value)};
  }
  const auto exponent = static_cast<int>(std::clamp(largest, -20000.0, 16000.0));
  return {{std::ldexp(sum.value.real(), exponent), std::ldexp(sum.value.imag(), exponent)},
          std::ldexp(sum.error, exponent)};
}

std::optional<QuickValue> residue_part(const Arguments& x, const QuickContour* contour,
                                       const EachSheet<Pole>& counted) {
  const auto poles = within_reach(counted);
  if (!poles) return std::nullopt;
  if (poles->empty()) return QuickValue{0.0L, 0.0L};
  PoleArguments arguments{.alpha = x.alpha,
                          .power = DoubleDouble{1.0, 0.0} + DoubleDouble{-x.beta.hi, -x.beta.lo},
                          .log_z = x.scaled.log};
  if (contour != nullptr) {
    arguments.half_log_mu = contour->half_log_mu;
    arguments.omega = contour->shape.omega;
    arguments.half_step_shift = contour->shape.half_step_shift;
  }
  return residue_sum(x, arguments, *poles);
}

std::optional<QuickValue> from_residues_alone(const Arguments& x) {
  EachSheet<Pole> principal;
  for (const Pole& pole : x.poles) {
    // Each root once: arg s* in (-pi, pi], for real z the upper half of them.
    const double argument = x.scaled.log.im.hi + 2.0 * pole.sheet * pi_double;
    if (argument > -x.alpha * pi_double && argument <= x.alpha * pi_double * 1.000001)
      principal.push_back(pole);
  }
  return residue_part(x, nullptr, principal);
}

const QuickContour& farther_from_poles(const QuickContours& contours,
                                       const EachSheet<std::complex<double>>& roots) {
  const auto clearance = [&](const QuickContour& contour) {
    double least = std::numeric_limits<double>::infinity();
    for (const auto& root : roots) least = std::min(least, contour.shape.steps_to_node(root));
    return least;
  };
  const auto& [plain, shifted] = contours.twins;
  return clearance(plain) >= clearance(shifted) ? plain : shifted;
}

DoubleDouble exponent_after(const Arguments& x, int peeled) {
  return exact_product(peeled + 1, x.alpha) + DoubleDouble{-x.beta.hi, -x.beta.lo};
}

std::optional<QuickValue> on_contour(const Arguments& x, const QuickContours& contours, int peeled) {
  const DoubleDouble exponent = exponent_after(x, peeled);
  EachSheet<std::complex<double>> roots;
  const double log_mu = std::log(contours.twins.front().shape.mu);
  const double modulus = std::exp(0.5 * (x.scaled.log.re.hi / x.alpha - log_mu));
  for (const Pole& pole : x.poles) roots.push_back(std::polar(modulus, 0.5 * pole.log.imag()));
  const QuickContour& contour = farther_from_poles(contours, roots);
  const auto [log_bound, distance] = contour.bound.at({.exponent = exponent.hi,
                                                       .alpha = x.alpha,
                                                       .log_size = x.scaled.log.re.hi,
                                                       .nearest_sheet = x.nearest_sheet,
                                                       .roots = {roots.data(), roots.size()}});
  EachSheet<Pole> counted;
  for (std::size_t i = 0; i < roots.size(); ++i) {
    if (ContourBound::counts(roots[i], distance)) counted.push_back(x.poles[i]);
  }
  const auto residues = residue_part(x, &contour, counted);
  if (!residues) return std::nullopt;
  QuickValue sum = head(x, peeled) + contour_sum(x, contour, exponent, peeled) + *residues;
  sum.error += peeled == 0 ? std::exp(log_bound)
                           : std::exp(static_cast<long double>(log_bound) - peeled * x.scaled.log.re.hi);
  return sum;
}

bool is_good(const QuickValue& value) { return value.error <= quick_tolerance * std::abs(value.value); }

// Next to beta = 0 and z = 0, where on a contour everything cancels: the first terms of the power series. As
// |1/Gamma(x)| <= 1.13 |x| for x >= -2^-30, the rest is at most 1.2 |z|^m (alpha (m+1) + |beta|).
std::optional<QuickValue> first_terms(const Arguments& x) {
  constexpr long double near = 0x1p-30L;
  constexpr int count = 3;
  const Value z(x.z);
  const double beta = std::abs(x.beta.hi);
  if (beta > near || size_of(z) > near) return std::nullopt;
  QuickValue sum{0.0L, 0.0L};
  Value power = 1.0L;
  for (int k = 0; k < count; ++k) {
    const Value term = power * reciprocal_gamma_of(x.beta + exact_product(k, x.alpha));
    sum = sum + QuickValue{term, few_ulps * size_of(term)};
    power *= z;
  }
  sum.error += 1.2L * size_of(power) * ((count + 1) * static_cast<long double>(x.alpha) + beta);
  return is_good(sum) ? std::optional(sum) : std::nullopt;
}

// One contour after the other, with and without peeling, until the bound is small enough; otherwise the best.
std::optional<QuickValue> on_contours(const Arguments& x) {
  constexpr int moderate = 4, large = 16;  // log2 |z|: peeling may help, and nothing else does
  std::optional<QuickValue> best;
  const auto try_with = [&](const QuickContours& contours, int peeled) {
    const auto value = on_contour(x, contours, peeled);
    if (value && (!best || value->error < best->error)) best = value;
    return best && is_good(*best);
  };
  for (const QuickContours& contours : all_contours()) {
    for (const int peeled : {0, 2}) {
      if (peeled == 0 ? x.scaled.exponent >= large : x.scaled.exponent < moderate) continue;
      const double exponent = exponent_after(x, peeled).hi;
      if (contours.fit(exponent - x.alpha, exponent) && try_with(contours, peeled)) return best;
    }
  }
  return best;
}

bool is_pole_of_gamma(const DoubleDouble& x) {
  return x.lo == 0.0 && x.hi <= 0.0 && std::floor(x.hi) == x.hi;
}

}  // namespace

std::optional<QuickValue> mittag_leffler_quick(double alpha, const DoubleDouble& beta,
                                               std::complex<double> z) {
  if (z == 0.0) {
    const long double value = is_pole_of_gamma(beta) ? 0.0L : reciprocal_gamma_of(beta);
    return QuickValue{value, few_ulps * std::abs(value)};
  }
  const Arguments x = arguments_of(alpha, beta, z);
  if (x.cut_free()) return from_residues_alone(x);
  if (!is_pole_of_gamma(beta)) {
    const auto near = first_terms(x);
    return near ? near : on_contours(x);
  }
  // The first term of the series is 0: E_{alpha,beta}(z) = z E_{alpha,alpha+beta}(z), where less cancels.
  auto shifted = mittag_leffler_quick(alpha, beta + DoubleDouble{alpha, 0.0}, z);
  if (!shifted) return std::nullopt;
  shifted->value *= Value(z);
  shifted->error = size_of(Value(z)) * shifted->error + few_ulps * size_of(shifted->value);
  return shifted;
}

}  // namespace fde
