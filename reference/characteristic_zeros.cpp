#include <array>
#include <optional>
#include <stdexcept>

#include "characteristic.hpp"

namespace fde {
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
    const Rectangle box = rectangle_of(polynomial, pi_long + beyond);
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
