#include "characteristic.hpp"

#include <array>
#include <optional>
#include <stdexcept>

namespace fde {
namespace {

// The terms c_i e^(o_i w), all scaled by the same positive number so that the largest is about 1.
template <class Real>
std::vector<Complex<Real>> scaled_terms(const Characteristic<Real>& characteristic, const Complex<Real>& w) {
  using std::exp, std::log;
  std::vector<Complex<Real>> terms;
  for (const auto& [coefficient, order] : characteristic.terms) terms.push_back(log(coefficient) + order * w);
  Real largest = real_part<Real>(terms.front());
  for (const auto& term : terms) largest = std::max(largest, real_part<Real>(term));
  for (auto& term : terms) term = exp(Complex<Real>(term - largest));
  return terms;
}

}  // namespace

template <class Real>
typename Characteristic<Real>::Step Characteristic<Real>::newton_step(const Complex<Real>& w) const {
  const auto scaled = scaled_terms(*this, w);
  Complex<Real> value(0), slope(0);
  Real size(0);
  for (std::size_t i = 0; i < scaled.size(); ++i) {
    value += scaled[i];
    slope += terms[i].order * scaled[i];
    size += size_of(scaled[i]);
  }
  return {value / slope, size_of(value) / size, size_of(slope) / size};
}

template <class Real>
Complex<Real> Characteristic<Real>::direction(const Complex<Real>& w) const {
  Complex<Real> sum(0);
  for (const auto& term : scaled_terms(*this, w)) sum += term;
  return sum;
}

template <class Real>
std::vector<Zero<Real>> polished(const Characteristic<Real>& characteristic,
                                 const std::vector<Zero<long double>>& zeros) {
  std::vector<Zero<Real>> results;
  for (const auto& [log, multiplicity, spread, isolation] : zeros) {
    Complex<Real> w(Real(log.real()), Real(log.imag()));
    Real before(1);
    for (int i = 0; multiplicity == 1 && i < 60; ++i) {
      const Complex<Real> step = characteristic.newton_step(w).value;
      const Real length = size_of(step);
      w -= step;
      // Quadratic convergence is over when the steps stop shrinking: what is left is rounding.
      if (length == 0 || (length < Real(1e-9) && length > before / 16)) break;
      before = length;
    }
    results.push_back({w, multiplicity, spread, isolation});
  }
  return results;
}

template struct Characteristic<long double>;
template struct Characteristic<BigReal>;
template std::vector<Zero<long double>> polished(const Characteristic<long double>&,
                                                 const std::vector<Zero<long double>>&);
template std::vector<Zero<BigReal>> polished(const Characteristic<BigReal>&,
                                             const std::vector<Zero<long double>>&);

namespace {

using Point = Complex<long double>;
using Polynomial = Characteristic<long double>;
constexpr long double pi_long = std::numbers::pi_v<long double>;

// The rectangle |Im w| <= height, left <= Re w <= right. Outside left and right a single term dominates P.
struct Rectangle {
  long double left, right, height;

  [[nodiscard]] bool contains(const Point& w) const {
    return w.real() >= left && w.real() <= right && std::abs(w.imag()) <= height;
  }
};

// log |s| where the terms i and j are of one size.
long double balance(const Polynomial& polynomial, std::size_t i, std::size_t j) {
  const auto &a = polynomial.terms[i], &b = polynomial.terms[j];
  return std::log(std::abs(a.coefficient) / std::abs(b.coefficient)) / (b.order - a.order);
}

Rectangle rectangle_of(const Polynomial& polynomial, long double height) {
  const std::size_t last = polynomial.terms.size() - 1;
  const long double margin = std::log(2.0L * static_cast<long double>(polynomial.terms.size()));
  Rectangle box{0.0L, 0.0L, height};
  for (std::size_t i = 0; i <= last; ++i) {
    const auto reach = [&](std::size_t j) {
      return margin / std::abs(polynomial.terms[i].order - polynomial.terms[j].order);
    };
    if (i != last) box.right = std::max(box.right, balance(polynomial, i, last) + reach(last));
    if (i != 0) box.left = std::min(box.left, balance(polynomial, 0, i) - reach(0));
  }
  return box;
}

// Change of arg P from a to b in pieces of at most pi/4; nothing where a zero is next to the way.
std::optional<long double> turn(const Polynomial& polynomial, const Point& a, const Point& at_a,
                                const Point& b, const Point& at_b, int depth) {
  const long double angle = std::arg(at_b * std::conj(at_a));
  if (std::abs(angle) < pi_long / 4.0L && std::abs(b - a) < 0.1L) return angle;
  if (depth == 0) return std::nullopt;
  const Point middle = (a + b) / 2.0L, at_middle = polynomial.direction(middle);
  const auto first = turn(polynomial, a, at_a, middle, at_middle, depth - 1);
  const auto second = first ? turn(polynomial, middle, at_middle, b, at_b, depth - 1) : std::nullopt;
  return second ? std::optional(*first + *second) : std::nullopt;
}

// Number of zeros inside, by the argument principle.
std::optional<int> count_zeros(const Polynomial& polynomial, const Rectangle& box) {
  constexpr int depth = 40;
  const std::array<Point, 4> corners{Point(box.left, -box.height), Point(box.right, -box.height),
                                     Point(box.right, box.height), Point(box.left, box.height)};
  long double total = 0.0L;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Point &a = corners[i], &b = corners[(i + 1) % corners.size()];
    const auto angle = turn(polynomial, a, polynomial.direction(a), b, polynomial.direction(b), depth);
    if (!angle) return std::nullopt;
    total += *angle;
  }
  return static_cast<int>(std::lround(total / (2.0L * pi_long)));
}

// Zeros closer than this are treated together.
constexpr long double too_close = 1e-6L;

// Newton's method with the zeros found so far divided out, so that it leads elsewhere. Right at one of them
// what is left after the division is noise: a second zero there is believed only where P is as flat as two
// zeros make it.
std::optional<Point> newton(const Polynomial& polynomial, const std::vector<Point>& found, Point w) {
  const auto found_before = [&](const Point& zero) { return std::abs(w - zero) < too_close; };
  for (int i = 0; i < 80; ++i) {
    const auto [step, residual, steepness] = polynomial.newton_step(w);
    const bool flat = steepness < 10.0L * too_close;
    if (!flat && std::ranges::any_of(found, found_before)) return std::nullopt;
    Point inverse = 1.0L / step;
    for (const auto& zero : found) inverse -= 1.0L / (w - zero);
    const Point deflated = residual == 0.0L ? Point(0.0L) : 1.0L / inverse;
    const long double length = std::abs(deflated);
    if (!std::isfinite(length)) return std::nullopt;
    if (length < 1e-9L && residual < 1e-15L) return w - deflated;
    w -= deflated * std::min(1.0L, 0.5L / length);
  }
  return std::nullopt;
}

// Points of the rectangle: first near the radii where two terms are of one size, and if that does not do,
// everywhere.
std::vector<Point> starting_points(const Polynomial& polynomial, const Rectangle& box, int refinement) {
  std::vector<long double> columns;
  for (std::size_t j = 1; j < polynomial.terms.size(); ++j) {
    for (std::size_t i = 0; i < j; ++i) {
      for (const long double offset : {0.0L, -0.5L, 0.5L, -1.5L, 1.5L})
        columns.push_back(balance(polynomial, i, j) + offset);
    }
  }
  const int extra = refinement == 0 ? 0 : 8 << (2 * refinement), rows = 8 << refinement;
  for (int k = 0; k < extra; ++k)
    columns.push_back(std::lerp(box.left, box.right, (static_cast<long double>(k) + 0.5L) / extra));
  std::vector<Point> points;
  for (const long double column : columns) {
    for (int k = 0; k < rows; ++k)
      points.emplace_back(column, box.height * ((2.0L * static_cast<long double>(k) + 1.0L) / rows - 1.0L));
  }
  return points;
}

std::vector<Point> all_zeros(const Polynomial& polynomial) {
  for (const long double beyond : {0.1L, 0.07L, 0.13L, 0.04L}) {
    const Rectangle box = rectangle_of(polynomial, pi_long + beyond);
    const std::optional<int> count = count_zeros(polynomial, box);
    if (!count) continue;
    std::vector<Point> found;
    for (const int refinement : {0, 1, 2, 3}) {
      for (const Point& start : starting_points(polynomial, box, refinement)) {
        if (std::ranges::count_if(found, [&](const Point& w) { return box.contains(w); }) >= *count) {
          std::erase_if(found, [&](const Point& w) { return !box.contains(w); });
          return found;
        }
        if (const auto zero = newton(polynomial, found, start)) found.push_back(*zero);
      }
    }
  }
  throw std::runtime_error("linear equation: not all zeros of the characteristic function were found");
}

}  // namespace

std::vector<Zero<long double>> find_zeros(const Characteristic<long double>& characteristic) {
  std::vector<Zero<long double>> zeros;
  if (characteristic.terms.size() < 2) return zeros;
  const std::vector<Point> points = all_zeros(characteristic);
  std::vector<bool> taken(points.size(), false);
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (taken[i] || std::abs(points[i].imag()) > pi_long - too_close) continue;
    Zero<long double> zero{.log = Point(0.0L), .multiplicity = 0};
    for (std::size_t j = 0; j < points.size(); ++j) {
      const long double distance = std::abs(points[j] - points[i]);
      if (distance > too_close) {
        zero.isolation = std::min(zero.isolation, distance);
        continue;
      }
      taken[j] = true;
      zero.log += points[j];
      zero.spread = std::max(zero.spread, distance);
      ++zero.multiplicity;
    }
    zero.log /= static_cast<long double>(zero.multiplicity);
    zeros.push_back(zero);
  }
  return polished(characteristic, zeros);
}

}  // namespace fde
