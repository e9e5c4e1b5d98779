// SPDX-License-Identifier: MIT
#include "fdebench/reference/special_functions/laplace/free_strip.hpp"

#include <algorithm>
#include <cmath>

#include "fdebench/reference/special_functions/numbers/constants.hpp"

namespace fde::reference {
namespace {

constexpr double rounding = 1e-7;  // an upper bound of the error of r*, also next to r* = 0

// log of a bound of |F| without the clearances. As max(|s|^alpha, |z_i|) is at least either argument, the
// first k factors take |s|^alpha and the others |z_i|, with the k that gives the smallest bound.
// log_of_power(e) is the log of |s|^e.
template <class LogOfPower>
double least_size(const SingularityFreeStrip::Product& product, double exponent,
                  const LogOfPower& log_of_power) {
  double constant = 0.0;
  for (const auto& factor : product.factors) constant -= factor.singularity_order * factor.log_size;
  double least = log_of_power(exponent) + constant;
  for (const auto& factor : product.factors) {
    exponent -= factor.singularity_order * product.alpha;
    constant += factor.singularity_order * factor.log_size;
    least = std::min(least, log_of_power(exponent) + constant);
  }
  return least;
}

// For an exponent between the least and the largest, |s|^e is at most the sum of its values for these two.
template <class LogOfPower>
double log_size(const SingularityFreeStrip::Product& product, const LogOfPower& log_of_power) {
  const double least = least_size(product, product.exponent, log_of_power);
  return product.exponent_range == 0.0
             ? least
             : log_sum(least, least_size(product, product.exponent + product.exponent_range, log_of_power));
}

}  // namespace

SingularityFreeStrip::Line SingularityFreeStrip::line_at(double distance) const {
  const auto& [offset, mu, omega, depth] = shape_;
  const double turns = omega * std::abs(1.0 - distance);
  const double inner = distance - corner_, outer = distance + corner_;
  const double height = offset + mu * distance * distance;  // Re s for real r
  return {distance,
          -turns - std::log1p(-std::exp(-turns)),
          height - mu * inner * inner + std::log(distance / inner),
          height - mu * outer * outer,
          LineIntegrals(mu, inner),
          LineIntegrals(mu, outer)};
}

SingularityFreeStrip::SingularityFreeStrip(const ShiftedShape& shape)
    : shape_(shape), corner_(std::sqrt(-shape.offset / shape.mu)) {
  for (const double part : {0.03, 0.1, 0.2, 0.35, 0.5, 0.6, 0.7, 0.8})
    near_lines_.push_back(line_at(corner_ + (1.0 - corner_) * part));
  const double farthest = shape.omega / (2.0 * shape.mu);
  for (const double distance : {farthest, 0.5 * farthest, 3.5, 2.5, 2.0, 1.7, 1.45}) {
    if (distance > 1.0 && distance <= farthest) far_lines_.push_back(line_at(distance));
  }
}

double SingularityFreeStrip::position_of(std::complex<double> root) const {
  return std::sqrt((root * root - shape_.offset) / shape_.mu).real();
}

// The positions r* of the singularities s* of a product relative to the contour.
class SingularityFreeStrip::SingularityPositions {
 public:
  SingularityPositions(const SingularityFreeStrip& strip, const Product& product)
      : strip_(strip), product_(product) {
    const auto& [offset, mu, omega, depth] = strip.shape_;
    for (const Factor& factor : product.factors) {
      std::vector<Place> places;
      places.reserve(factor.roots.size());
      for (const auto& root : factor.roots) {
        const double size = std::abs(root);
        if (root.real() > 0.0) {
          const auto place = std::sqrt((root * root - offset) / mu);
          places.push_back({place.real(), std::abs(place), mu / (size * size)});
        } else {
          places.push_back({-infinity_double, 0.0, std::sqrt(mu) / size});
        }
      }
      places_.push_back(std::move(places));
    }
  }

  // Calls function(Re r*) for every s* on the principal sheet.
  template <class Function>
  void for_each(const Function& function) const {
    for (const auto& places : places_) {
      for (const Place& place : places) {
        if (place.re > -infinity_double) function(place.re);
      }
    }
  }

  [[nodiscard]] double log_clearance(double distance) const {
    const double across = std::sqrt(distance * distance - strip_.corner_ * strip_.corner_) - rounding;
    double sum = 0.0;
    for (std::size_t i = 0; i < places_.size(); ++i) {
      const Factor& factor = product_.factors[i];
      double least = std::min(1.0, factor.nearest_other_argument - product_.alpha * pi_double);
      for (const auto& [re, size, scale] : places_[i]) {
        // |log s - log s*| is at least times share / (1 + share)
        const bool other_sheet = re == -infinity_double;
        const double gap = std::abs(re - distance) - rounding, times = other_sheet ? 2.0 : 1.0;
        const double share = scale * (other_sheet ? across : std::max(0.0, gap) * std::max(gap, size));
        least = std::min(least, times * product_.alpha * (1.0 - rounding) / (1.0 + 1.0 / share));
      }
      if (!(least > 0.0)) return -infinity_double;
      sum += factor.singularity_order * std::log(least / 10.0);
    }
    return sum;
  }

 private:
  struct Place {
    double re, size, scale;
  };
  const SingularityFreeStrip& strip_;
  const Product& product_;
  std::vector<std::vector<Place>> places_;
};

// A geometric series from the first truncated node on, as in ContourBound: |s| grows by at most the factor
// e^(2 step / theta) from one node to the next.
double SingularityFreeStrip::log_truncation_error(const Product& product) const {
  const auto& [offset, mu, omega, depth] = shape_;
  const double step = 2.0 * pi_double / omega, theta = std::sqrt(1.0 + depth / mu);
  const double log_modulus = std::log(std::hypot(offset + mu * (1.0 - theta * theta), 2.0 * mu * theta));
  double largest = 0.0;
  const double power = log_size(product, [&](double exponent) {
    largest = std::max(largest, exponent);
    return exponent * log_modulus;
  });
  const double ratio = std::exp(-2.0 * mu * theta * step + (2.0 * largest + 1.0) * step / theta);
  if (!(ratio < 1.0)) return infinity_double;
  const double weight =
      std::log(2.0 * step * mu * std::sqrt(1.0 + theta * theta) / pi_double) + offset - depth;
  return weight + power - std::log1p(-ratio);
}

double SingularityFreeStrip::log_line(const Line& line, const Product& product) {
  const double size = log_size(product, [&](double exponent) {
    return exponent <= 0.0 ? line.log_inner + line.inner.log_at(exponent)
                           : line.log_outer + line.outer.log_at(exponent);
  });
  return size + line.log_factor;
}

template <class Admits>
SingularityFreeStrip::LineBound SingularityFreeStrip::best_line(const std::vector<Line>& lines,
                                                                const Product& product,
                                                                const SingularityPositions& places,
                                                                const Admits& admits) {
  const double third = std::log(3.0);  // the whole bound is the sum of three
  LineBound best{infinity_double, -infinity_double, 0.0};
  for (const Line& line : lines) {
    if (best.log_bound <= product.sufficient_log_bound - third) break;
    if (!admits(line.distance)) continue;
    const double clearance = places.log_clearance(line.distance), bound = log_line(line, product) - clearance;
    if (bound < best.log_bound) best = {bound, clearance, line.distance};
  }
  return best;
}

std::optional<SingularityFreeStrip::Result> SingularityFreeStrip::bound_for(const Product& product) const {
  constexpr double most_size = 1e100;  // its square does not overflow
  for (const Factor& factor : product.factors) {
    for (const auto& root : factor.roots) {
      if (!(std::abs(root) < most_size)) return std::nullopt;
    }
  }
  const SingularityPositions places(*this, product);
  double innermost = corner_, outermost = infinity_double;
  Result result{infinity_double, 0.0, 0.0, false, false};
  places.for_each([&](double place) {
    if (place < 1.0) {
      result.inside = true;
      innermost = std::max(innermost, place);
    } else {
      result.outside = true;
      outermost = std::min(outermost, place);
    }
  });
  const LineBound near = best_line(near_lines_, product, places, [=](double d) { return d > innermost; });
  const LineBound far = best_line(far_lines_, product, places, [=](double d) { return d < outermost; });
  if (std::isinf(near.log_bound) || std::isinf(far.log_bound)) return std::nullopt;
  result.least_size = shape_.mu * (near.distance * near.distance - corner_ * corner_);
  result.log_clearance = std::min(near.log_clearance, far.log_clearance);
  result.log_bound = log_sum(log_sum(near.log_bound, far.log_bound),
                             log_truncation_error(product) - places.log_clearance(1.0));
  return result;
}

}  // namespace fde::reference
