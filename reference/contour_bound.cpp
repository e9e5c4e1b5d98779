#include "contour_bound.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace fde {
namespace {

constexpr double pi_double = std::numbers::pi;

// log(e^a + e^b)
double log_sum(double a, double b) {
  const double larger = std::max(a, b);
  return larger + std::log1p(std::exp(std::min(a, b) - larger));
}

// log of min(1, alpha distance) / 10, the distance being from the poles to points with |r - r*| >= gap(r*).
template <class Gap>
double log_clearance(const ContourBound::Quotient& quotient, const Gap& gap) {
  double ratio = std::numeric_limits<double>::infinity();
  for (const auto& root : quotient.roots)
    ratio = std::min(ratio, gap(root) / (std::abs(root.real()) + std::abs(root.imag())));
  const double others = std::min(1.0, quotient.nearest_sheet - quotient.alpha * pi_double);
  const double distance = std::min(others, 2.0 * quotient.alpha / (1.0 + 1.0 / ratio));
  return distance > 0.0 ? std::log(distance / 10.0) : -std::numeric_limits<double>::infinity();
}

}  // namespace

double ContourShape::step() const { return 2.0 * pi_double / omega; }

double ContourShape::steps_to_node(std::complex<double> root) const {
  const double along = root.imag() / step() - (half_step_shift ? 0.5 : 0.0);
  return std::max(std::abs(along - std::round(along)), std::abs(root.real() - 1.0) / step());
}

// |ds| = 2 mu |d + i x| dx. For exponents e above 1, convexity gives for every 0 < p < 1
//   (d^2 + x^2)^e <= p^(1-e) d^(2e) + (1-p)^(1-e) x^(2e).
double log_line_integral(double mu, double distance, double exponent) {
  const double least = mu * distance * distance, length = distance * std::sqrt(pi_double * mu) + 1.0;
  const double near = exponent * std::log(least) + std::log(length);
  if (exponent <= 0.0) return least + near - std::log(pi_double);
  const double far =
      log_sum(std::log(distance * std::sqrt(mu)) + std::lgamma(exponent + 0.5), std::lgamma(exponent + 1.0));
  const auto split = [&](double p) {
    const double power = std::max(0.0, exponent - 1.0);
    return log_sum(near - power * std::log(p), far - power * std::log1p(-p));
  };
  return least + std::min(split(0.5), split(1.0 / (1.0 + exponent))) - std::log(pi_double);
}

namespace {
constexpr int least_exponent = -64, most_exponent = 64;
}

LineIntegrals::LineIntegrals(double mu, double distance) : mu_(mu), distance_(distance) {
  for (int e = least_exponent; e <= most_exponent; ++e) logs_.push_back(log_line_integral(mu, distance, e));
}

double LineIntegrals::log_at(double exponent) const {
  const double place = exponent - least_exponent;
  if (!(place >= 0.0 && exponent < most_exponent)) return log_line_integral(mu_, distance_, exponent);
  const auto below = static_cast<std::size_t>(place);
  return std::lerp(logs_[below], logs_[below + 1], place - std::floor(place));
}

ContourBound::ContourBound(const ContourShape& shape)
    : shape_(shape), far_(shape.omega / (2.0 * shape.mu)), far_line_(shape.mu, far_) {
  for (double distance = 1.0 / shape.omega; distance < 0.9; distance *= 3.0) {
    distances_.push_back(distance);
    lines_.emplace_back(shape.mu, distance);
  }
}

double ContourBound::log_line(const LineIntegrals& line, double distance, const Quotient& quotient) const {
  const double size = std::min(line.log_at(quotient.exponent - quotient.alpha),
                               line.log_at(quotient.exponent) - quotient.log_size);
  const double turns = shape_.omega * std::abs(1.0 - distance);
  const double clearance =
      log_clearance(quotient, [&](std::complex<double> root) { return std::abs(root.real() - distance); });
  return size - turns - std::log1p(-std::exp(-turns)) - clearance;
}

// A geometric series from the first node that is left out, theta: two nodes, conjugate.
double ContourBound::log_left_out(const Quotient& quotient) const {
  const double step = shape_.step(), mu = shape_.mu, theta = std::sqrt(1.0 + shape_.depth / mu);
  const double modulus = mu * (1.0 + theta * theta), e = quotient.exponent;
  const double power =
      std::min((e - quotient.alpha) * std::log(modulus), e * std::log(modulus) - quotient.log_size);
  const double ratio = std::exp(-2.0 * mu * theta * step + std::max(0.0, 2.0 * e + 1.0) * step / theta);
  if (!(ratio < 1.0)) return std::numeric_limits<double>::infinity();
  const double weight = std::log(2.0 * step * std::sqrt(mu * modulus) / pi_double) - shape_.depth;
  const double clearance =
      log_clearance(quotient, [&](std::complex<double> root) { return shape_.steps_to_node(root) * step; });
  return weight + power - std::log1p(-ratio) - clearance;
}

ContourBound::Result ContourBound::at(const Quotient& quotient) const {
  Result best{std::numeric_limits<double>::infinity(), distances_.front()};
  for (std::size_t i = 0; i < lines_.size(); ++i) {
    const double bound = log_line(lines_[i], distances_[i], quotient);
    if (bound < best.log_bound) best = {bound, distances_[i]};
  }
  best.log_bound =
      log_sum(best.log_bound, log_sum(log_line(far_line_, far_, quotient), log_left_out(quotient)));
  return best;
}

}  // namespace fde
