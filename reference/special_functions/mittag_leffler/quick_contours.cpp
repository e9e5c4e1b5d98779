// SPDX-License-Identifier: MIT
#include "fdebench/reference/special_functions/mittag_leffler/quick_contours.hpp"

#include <algorithm>
#include <cmath>

namespace fde::reference {

namespace {

constexpr int digits = 45;

DoubleDouble half_log(double x) {
  const Precision precision(digits);
  return to_double_double(log(BigReal(x)) / 2);
}

ContourNodes nodes_of(const ContourShape& shape) {
  const Precision precision(digits);
  return ContourNodes(Contour<BigReal>(shape.mu, shape.omega, shape.depth, shape.half_step_shift));
}

// The poles whose residues are not negligible; nullopt where the phase of a large one cannot be computed.
std::optional<PerSheet<Pole<double>>> within_reach(const PerSheet<Pole<double>>& counted) {
  constexpr double most_log = 26.0, clear = 1e-7;
  PerSheet<Pole<double>> poles;
  for (const auto& pole : counted) {
    if (pole.log.real() < most_log) {
      poles.push_back(pole);
    } else if (std::cos(pole.log.imag()) > -clear) {  // otherwise e^s* is negligible
      return std::nullopt;
    }
  }
  return poles;
}

PoleArguments kernel_arguments(const QuickArguments& x, const QuickContour* contour) {
  PoleArguments arguments{.alpha = x.alpha,
                          .power = DoubleDouble{1.0, 0.0} + DoubleDouble{-x.beta.hi, -x.beta.lo},
                          .log_z = x.scaled.log};
  if (contour != nullptr) {
    arguments.half_log_mu = contour->half_log_mu;
    arguments.omega = contour->shape.omega;
    arguments.half_step_shift = contour->shape.half_step_shift;
  }
  return arguments;
}

PerSheet<Residue> residues_of(const PoleArguments& arguments, const PerSheet<Pole<double>>& poles) {
  PerSheet<Residue> residues;
  for (std::size_t first = 0; first < poles.size(); first += double_double_lanes) {
    const std::size_t count = std::min(poles.size() - first, double_double_lanes);
    std::array<double, double_double_lanes> sheets{};
    sheets.fill(poles[first].sheet);
    for (std::size_t i = 0; i < count; ++i) sheets[i] = poles[first + i].sheet;
    const Residues some = residues_at(arguments, sheets, count);
    residues.insert(residues.end(), some.begin(), some.begin() + static_cast<std::ptrdiff_t>(count));
  }
  return residues;
}

ContourNodes nodes_of(const ShiftedShape& shape) {
  const Precision precision(digits);
  return ContourNodes(Contour<BigReal>(shape.mu, shape.omega, shape.depth, false), shape.offset);
}

}  // namespace

QuickContour::QuickContour(const ContourShape& of)
    : shape(of), bound(of), half_log_mu(half_log(of.mu)), nodes(nodes_of(of)) {}

const QuickContour& QuickContours::away_from(std::span<const std::complex<double>> roots) const {
  const auto clearance = [&](const QuickContour& contour) {
    double least = std::numeric_limits<double>::infinity();
    for (const auto& root : roots) least = std::min(least, contour.shape.steps_to_node(root));
    return least;
  };
  const auto& [plain, shifted] = staggered;
  return clearance(plain) >= clearance(shifted) ? plain : shifted;
}

// mu near -exponent keeps the terms as small as 1/Gamma(-exponent); with a large depth the sum extends until
// s^exponent e^s has decayed. The last contour has terms of the size of the value, and three times as many:
// its rounding error is the smallest.
const std::array<QuickContours, 6>& quick_contours() {
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

ScaledArgument::ScaledArgument(std::complex<double> z)
    : exponent(std::ilogb(std::max(std::abs(z.real()), std::abs(z.imag())))) {
  value = {std::scalbn(z.real(), -exponent), std::scalbn(z.imag(), -exponent)};
  log = complex_logarithm(value);
  const DoubleDouble head = exact_product(exponent, ln2.hi), tail{exponent * ln2.lo, 0.0};
  log.re = log.re + head + tail;
}

QuickArguments::QuickArguments(double order, const DoubleDouble& parameter, std::complex<double> argument)
    : alpha(order),
      beta(parameter),
      z(argument),
      scaled(z),
      poles(poles_of(alpha, std::complex(scaled.log.re.hi, scaled.log.im.hi), real() ? 0 : -max_sheet)) {}

bool QuickArguments::represents_conjugate(const Pole<double>& pole) const {
  const int half_turns =
      2 * pole.sheet + (z.real() < 0.0 ? 1 : 0);  // arg z / pi on the sheet of the pole, for real z
  return real() && half_turns != 0 && half_turns != alpha;
}

// The residues are scaled by the largest exponent while they are added.
std::optional<QuickValue> residue_sum(const QuickArguments& x, const QuickContour* contour,
                                      const PerSheet<Pole<double>>& counted) {
  const auto poles = within_reach(counted);
  if (!poles) return std::nullopt;
  if (poles->empty()) return QuickValue{0.0L, 0.0L};
  const auto residues = residues_of(kernel_arguments(x, contour), *poles);
  double largest = -std::numeric_limits<double>::infinity();
  for (const auto& residue : residues) {
    if (std::isnan(residue.exponent))
      return std::nullopt;  // log z / alpha with log z = 0 and 1 / alpha infinite
    largest = std::max(largest, residue.exponent);
  }
  QuickValue sum{0.0L, 0.0L};
  for (std::size_t i = 0; i < residues.size(); ++i) {
    const auto below = static_cast<int>(std::max(residues[i].exponent - largest, -20000.0));
    const long double scale = std::ldexp(x.represents_conjugate((*poles)[i]) ? 2.0L : 1.0L, below);
    std::complex<long double> value = scale * to_long(residues[i].value);
    const long double error = norm1(value) * residues[i].relative_error;
    if (x.real()) value = value.real();
    sum = sum + QuickValue{value, error + few_ulps * norm1(value)};
  }
  const auto exponent = static_cast<int>(std::clamp(largest, -20000.0, 16000.0));
  return QuickValue{{std::ldexp(sum.value.real(), exponent), std::ldexp(sum.value.imag(), exponent)},
                    std::ldexp(sum.error, exponent)};
}

std::optional<QuickValue> sum_of_all_residues(const QuickArguments& x) {
  PerSheet<Pole<double>> principal;
  for (const auto& pole : x.poles.on_near_sheets) {
    // Each root once: arg s* in (-pi, pi], for real z the upper half of them.
    const double argument = x.scaled.log.im.hi + 2.0 * pole.sheet * pi<double>();
    if (argument > -x.alpha * pi<double>() && argument <= x.alpha * pi<double>() * 1.000001)
      principal.push_back(pole);
  }
  return residue_sum(x, nullptr, principal);
}

ShiftedContour::ShiftedContour(const ShiftedShape& of) : shape(of), strip(of), nodes(nodes_of(of)) {}

// The first ones suffice unless singularities have a large imaginary part. Those with mu = 16, 30, 60, 100
// enclose singularities of increasing imaginary part, the one with mu = 64 some on the positive axis; the one
// with mu = 2 leaves singularities far to the left outside.
const std::array<ShiftedContour, 8>& shifted_contours() {
  static const std::array<ShiftedContour, 8> all{
      ShiftedContour({0.0, 6.0, 52.0, 43.5}),     ShiftedContour({0.0, 7.0, 64.0, 60.0}),
      ShiftedContour({0.0, 2.0, 64.0, 60.0}),     ShiftedContour({0.0, 16.0, 128.0, 70.0}),
      ShiftedContour({-14.0, 30.0, 372.0, 46.0}), ShiftedContour({-44.0, 60.0, 800.0, 20.0}),
      ShiftedContour({0.0, 64.0, 420.0, 110.0}),  ShiftedContour({-84.0, 100.0, 1400.0, 12.0})};
  return all;
}

SingularityRoots::SingularityRoots(double alpha, const std::complex<double>& log_z, int first_sheet)
    : log_size(log_z.real()), poles(poles_of(alpha, log_z, first_sheet)) {
  for (const auto& pole : poles.on_near_sheets)
    roots.push_back(std::polar(std::exp(0.5 * pole.log.real()), 0.5 * pole.log.imag()));
}

double SingularityRoots::growth() const {
  double largest = 0.0;
  for (const auto& root : roots) {
    if (root.real() > 0.0) largest = std::max(largest, (root * root).real());
  }
  return largest;
}

}  // namespace fde::reference
