#include <optional>
#include <stdexcept>

#include "transfer_functions/characteristic.hpp"
#include "transfer_functions/characteristic_count.hpp"

namespace fde {
namespace {

using Point = Rectangle::Point;
using Polynomial = Characteristic<long double>;
constexpr long double pi_long = std::numbers::pi_v<long double>;

// log |s| where the terms i and j are of one size.
long double balance(const Polynomial& polynomial, std::size_t i, std::size_t j) {
  const auto &a = polynomial.terms[i], &b = polynomial.terms[j];
  return std::log(std::abs(a.coefficient) / std::abs(b.coefficient)) / (b.order - a.order);
}

// Outside left and right a single term dominates P.
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

// Beyond this log |s|, reached by orders next to each other, a zero is nothing at any time that a double has:
// next to the branch point, or decaying at once. One that grows is infinite at once.
constexpr long double farthest = 800.0L;

Rectangle within_reach(const Polynomial& polynomial, const Rectangle& box) {
  const Rectangle growing{farthest, box.right, pi_long / 2.0L};
  if (growing.right > farthest && count_zeros(polynomial, growing).value_or(1) != 0)
    throw std::runtime_error("linear problem: a solution grows beyond all numbers at once");
  return {std::max(box.left, -farthest), std::min(box.right, farthest), box.height};
}

// Zeros closer than this are treated together.
constexpr long double too_close = 1e-6L;

// A zero as well as it can be told: P is rounding noise within about the distance blur.
struct Found {
  Point zero;
  long double blur;
};

// Newton's method with the zeros found so far divided out, so that it leads elsewhere. Right at one of them
// what is left after the division is noise: a second zero there is believed only where P is as flat as two
// zeros make it. Near several together P drowns in its rounding before the steps become small.
std::optional<Found> newton(const Polynomial& polynomial, const std::vector<Found>& found, Point w) {
  constexpr long double most_blurred = 0.05L;
  const auto found_before = [&](const Found& other) { return std::abs(w - other.zero) < too_close; };
  for (int i = 0; i < 80; ++i) {
    const auto [step, residual, steepness] = polynomial.newton_step(w);
    const bool flat = steepness < 10.0L * too_close;
    if (!flat && std::ranges::any_of(found, found_before)) return std::nullopt;
    const long double noise =
        epsilon<long double>() * (2.0L + 2.0L * polynomial.terms.back().order * std::abs(w));
    const long double blur = std::min(noise / steepness, most_blurred);
    if (flat && residual < noise) return Found{w, blur};
    Point inverse = 1.0L / step;
    for (const auto& other : found) inverse -= 1.0L / (w - other.zero);
    const Point deflated = residual == 0.0L ? Point(0.0L) : 1.0L / inverse;
    const long double length = std::abs(deflated);
    if (!std::isfinite(length)) return std::nullopt;
    if (length < 1e-9L && residual < 1e-15L) return Found{w - deflated, blur};
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

std::vector<Found> all_zeros(const Polynomial& polynomial) {
  for (const long double beyond : {0.1L, 0.07L, 0.13L, 0.04L}) {
    const Rectangle box = within_reach(polynomial, rectangle_of(polynomial, pi_long + beyond));
    const std::optional<int> count = count_zeros(polynomial, box);
    if (!count) continue;
    const auto inside = [&](const Found& found) { return box.contains(found.zero); };
    std::vector<Found> found;
    for (const int refinement : {0, 1, 2, 3}) {
      for (const Point& start : starting_points(polynomial, box, refinement)) {
        if (std::ranges::count_if(found, inside) >= *count) {
          std::erase_if(found, [&](const Found& other) { return !inside(other); });
          return found;
        }
        if (const auto zero = newton(polynomial, found, start)) found.push_back(*zero);
      }
    }
  }
  throw std::runtime_error("linear problem: not all zeros of the characteristic function were found");
}

// The indices of those that hang together with the first by distances at which they cannot be told apart.
std::vector<std::size_t> cluster_of(const std::vector<Found>& found, std::size_t first) {
  std::vector<std::size_t> cluster{first};
  for (std::size_t k = 0; k < cluster.size(); ++k) {
    const Found& a = found[cluster[k]];
    for (std::size_t j = 0; j < found.size(); ++j) {
      const Found& b = found[j];
      const long double apart = std::max(too_close, 8.0L * std::max(a.blur, b.blur));
      if (std::abs(a.zero - b.zero) <= apart && std::ranges::find(cluster, j) == cluster.end())
        cluster.push_back(j);
    }
  }
  return cluster;
}

Zero<long double> merged(const std::vector<Found>& found, const std::vector<std::size_t>& cluster) {
  Zero<long double> zero{.log = Point(0.0L), .multiplicity = static_cast<int>(cluster.size())};
  for (const std::size_t i : cluster) zero.log += found[i].zero / static_cast<long double>(cluster.size());
  for (std::size_t i = 0; i < found.size(); ++i) {
    const long double distance = std::abs(found[i].zero - zero.log);
    if (std::ranges::find(cluster, i) == cluster.end()) {
      zero.isolation = std::min(zero.isolation, distance);
    } else if (zero.multiplicity > 1) {
      zero.spread = std::max(zero.spread, distance + found[i].blur);
    }
  }
  return zero;
}

}  // namespace

std::vector<Zero<long double>> find_zeros(const Characteristic<long double>& characteristic) {
  std::vector<Zero<long double>> zeros;
  if (characteristic.terms.size() < 2) return zeros;
  const std::vector<Found> found = all_zeros(characteristic);
  std::vector<bool> taken(found.size(), false);
  for (std::size_t i = 0; i < found.size(); ++i) {
    if (taken[i]) continue;
    const auto cluster = cluster_of(found, i);
    for (const std::size_t j : cluster) taken[j] = true;
    const auto zero = merged(found, cluster);
    if (std::abs(zero.log.imag()) <= pi_long - std::max(too_close, zero.spread)) zeros.push_back(zero);
  }
  return polished(characteristic, zeros);
}

}  // namespace fde
