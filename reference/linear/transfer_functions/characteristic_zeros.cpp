// SPDX-License-Identifier: MIT
#include "fdebench/reference/linear/transfer_functions/characteristic_zeros.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <optional>
#include <stdexcept>
#include <utility>

#include "fdebench/reference/linear/transfer_functions/characteristic_function.hpp"
#include "fdebench/reference/special_functions/numbers/constants.hpp"

namespace fde::reference {
namespace {

using Point = Rectangle::Point;

// log |s| where the terms i and j have the same modulus.
long double balance(const CharacteristicFunction& function, std::size_t i, std::size_t j) {
  const auto &a = function.terms()[i], &b = function.terms()[j];
  return (a.log_coefficient.real() - b.log_coefficient.real()) / (b.order - a.order);
}

// Left and right of the rectangle a single term dominates P.
Rectangle rectangle_of(const CharacteristicFunction& function, long double height) {
  const std::size_t last = function.terms().size() - 1;
  const long double margin = std::log(2.0L * static_cast<long double>(function.terms().size()));
  Rectangle box{0.0L, 0.0L, height};
  for (std::size_t i = 0; i <= last; ++i) {
    const auto reach = [&](std::size_t j) {
      return margin / std::abs(function.terms()[i].order - function.terms()[j].order);
    };
    if (i != last) box.right = std::max(box.right, balance(function, i, last) + reach(last));
    if (i != 0) box.left = std::min(box.left, balance(function, 0, i) - reach(0));
  }
  return box;
}

// Above this |log |s||, which close orders can lead to, a zero contributes nothing at any time in the range
// of double: it is next to the branch point or its mode decays at once. A growing mode overflows at once.
constexpr long double farthest = 800.0L;

Rectangle within_reach(const CharacteristicFunction& function, const Rectangle& box) {
  const Rectangle growing{farthest, box.right, pi_long / 2.0L};
  if (growing.right > farthest && count_zeros(function, growing).value_or(1) != 0)
    throw std::runtime_error("linear problem: a solution grows beyond all numbers at once");
  return {std::max(box.left, -farthest), std::min(box.right, farthest), box.height};
}

// Zeros closer than this are treated as a cluster.
constexpr long double cluster_distance = CharacteristicFunction::Derivatives::cluster_distance;

// A zero and its uncertainty: within about this distance of the zero P is rounding noise.
struct ApproximateZero {
  Point zero;
  long double uncertainty;
};

// Newton's method, deflated by the zeros found so far. At one of them the deflated function is noise: a
// second zero there is accepted only where dP/dw is as small, compared with its derivative, as between two
// zeros. Steps are limited to a fraction of |P'/P''|.
std::optional<ApproximateZero> newton(const CharacteristicFunction& function,
                                      const std::vector<ApproximateZero>& found, Point w) {
  constexpr long double most_blurred = 0.05L, longest = 100.0L;
  const auto found_before = [&](const ApproximateZero& other) {
    return std::abs(w - other.zero) < cluster_distance;
  };
  for (int i = 0; i < 80; ++i) {
    const auto known = function.derivatives(w);
    const auto& [value, first, second, noise] = known;
    const bool flat = known.is_near_multiple_zero();
    if (!flat && std::ranges::any_of(found, found_before)) return std::nullopt;
    const long double blur = std::min(noise / std::abs(first), most_blurred);
    if (flat && std::abs(value) < noise) return ApproximateZero{w, blur};
    Point inverse = first / value;
    for (const auto& other : found) inverse -= 1.0L / (w - other.zero);
    const Point deflated = value == 0.0L ? Point(0.0L) : 1.0L / inverse;
    const long double length = std::abs(deflated);
    if (!std::isfinite(length)) return std::nullopt;
    if (length < 1e-9L && std::abs(value) < 1e-15L)
      return ApproximateZero{w - deflated, std::min(blur + length, most_blurred)};
    const long double most = 0.5L * std::clamp(std::abs(first) / std::abs(second), 1.0L, longest);
    w -= deflated * std::min(1.0L, most / length);
  }
  return std::nullopt;
}

// The search for a given number of zeros of a rectangle.
class ZeroSearch {
 public:
  explicit ZeroSearch(const CharacteristicFunction& function) : function_(function) {}

  // First near the radii where two terms have the same modulus; if that does not find all, everywhere.
  bool finds_all(const Rectangle& box, int count) {
    for (std::size_t j = 1; j < function_.terms().size(); ++j) {
      for (std::size_t i = 0; i < j; ++i) {
        for (const long double offset : {0.0L, -0.5L, 0.5L, -1.5L, 1.5L})
          if (newton_from_column(box, balance(function_, i, j) + offset, fewest_rows, count)) return true;
      }
    }
    return bisect(box, count);
  }
  [[nodiscard]] std::vector<ApproximateZero> inside(const Rectangle& box) const {
    std::vector<ApproximateZero> result;
    std::ranges::copy_if(found_, std::back_inserter(result),
                         [&](const ApproximateZero& found) { return box.contains(found.zero); });
    return result;
  }

 private:
  static constexpr int fewest_rows = 8, most_rows = 64;

  [[nodiscard]] bool complete(const Rectangle& box, int count) const {
    return std::ranges::count_if(
               found_, [&](const ApproximateZero& found) { return box.contains(found.zero); }) >= count;
  }

  // Newton's method from `rows` starting points with Re w = column. True if `count` zeros of box are known.
  bool newton_from_column(const Rectangle& box, long double column, int rows, int count) {
    for (int k = 0; k < rows; ++k) {
      if (complete(box, count)) return true;
      const long double height = box.height * ((2.0L * static_cast<long double>(k) + 1.0L) / rows - 1.0L);
      if (const auto zero = newton(function_, found_, Point(column, height))) found_.push_back(*zero);
    }
    return complete(box, count);
  }

  // Bisects the box, with a count of the zeros of each half, down to a width at which Newton's method finds
  // them.
  bool bisect(const Rectangle& box, int count) {
    constexpr long double narrow = 1.0L;
    const long double width = box.right - box.left;
    for (int rows = fewest_rows; rows <= (width > narrow ? fewest_rows : most_rows); rows *= 2)
      if (newton_from_column(box, (box.left + box.right) / 2.0L, rows, count)) return true;
    if (width <= narrow / 16.0L) return false;
    for (const long double part : {0.5L, 0.47L, 0.54L}) {
      const long double middle = box.left + part * width;
      const Rectangle left{box.left, middle, box.height}, right{middle, box.right, box.height};
      const auto on_left = count_zeros(function_, left);
      if (!on_left) continue;
      const bool found_left = bisect(left, *on_left);
      return bisect(right, count - *on_left) && found_left;
    }
    return false;
  }

  const CharacteristicFunction& function_;
  std::vector<ApproximateZero> found_;
};

std::vector<ApproximateZero> all_zeros(const CharacteristicFunction& function) {
  for (const long double beyond : {0.1L, 0.07L, 0.13L, 0.04L}) {
    const Rectangle box = within_reach(function, rectangle_of(function, pi_long + beyond));
    const std::optional<int> count = count_zeros(function, box);
    if (!count) continue;
    ZeroSearch search(function);
    if (search.finds_all(box, *count)) return search.inside(box);
  }
  throw std::runtime_error("linear problem: not all zeros of the characteristic function were found");
}

// Indices of the zeros connected to `first` by steps too short to separate two zeros.
std::vector<std::size_t> cluster_of(const std::vector<ApproximateZero>& found, std::size_t first) {
  std::vector<std::size_t> cluster{first};
  for (std::size_t k = 0; k < cluster.size(); ++k) {
    const ApproximateZero& a = found[cluster[k]];
    for (std::size_t j = 0; j < found.size(); ++j) {
      const ApproximateZero& b = found[j];
      const long double apart = std::max(cluster_distance, 8.0L * std::max(a.uncertainty, b.uncertainty));
      if (std::abs(a.zero - b.zero) <= apart && std::ranges::find(cluster, j) == cluster.end())
        cluster.push_back(j);
    }
  }
  return cluster;
}

Zero<long double> merged(const std::vector<ApproximateZero>& found, const std::vector<std::size_t>& cluster) {
  Zero<long double> zero{.log = Point(0.0L), .multiplicity = static_cast<int>(cluster.size())};
  for (const std::size_t i : cluster) zero.log += found[i].zero / static_cast<long double>(cluster.size());
  for (std::size_t i = 0; i < found.size(); ++i) {
    const long double distance = std::abs(found[i].zero - zero.log);
    if (std::ranges::find(cluster, i) == cluster.end()) {
      zero.isolation = std::min(zero.isolation, distance);
    } else if (zero.multiplicity > 1) {
      zero.radius = std::max(zero.radius, distance + found[i].uncertainty);
    }
  }
  return zero;
}

// A simple zero to the last digit: Newton's method converges quadratically.
Point newton_refined(const CharacteristicFunction& function, Point zero) {
  for (int i = 0; i < 2; ++i) {
    const auto known = function.derivatives(zero);
    zero -= known.value / known.first;
  }
  return zero;
}

// Those of the strip, and of its surroundings.
std::vector<Zero<long double>> zeros_about_strip(const LinearTransform& transform) {
  std::vector<Zero<long double>> zeros;
  const CharacteristicFunction function(transform);
  if (function.terms().size() < 2) return zeros;
  const std::vector<ApproximateZero> found = all_zeros(function);
  std::vector<bool> taken(found.size(), false);
  for (std::size_t i = 0; i < found.size(); ++i) {
    if (taken[i]) continue;
    const auto cluster = cluster_of(found, i);
    for (const std::size_t j : cluster) taken[j] = true;
    auto zero = merged(found, cluster);
    if (zero.multiplicity == 1) zero.log = newton_refined(function, zero.log);
    zeros.push_back(zero);
  }
  return zeros;
}

// The distance from the edge of the strip within which a zero counts as on the cut.
long double width_of_cut(const Zero<long double>& zero) { return std::max(cluster_distance, zero.radius); }

}  // namespace

std::vector<Zero<long double>> find_zeros(const LinearTransform& transform) {
  auto zeros = zeros_about_strip(transform);
  std::erase_if(zeros,
                [](const auto& zero) { return std::abs(zero.log.imag()) > pi_long - width_of_cut(zero); });
  return zeros;
}

std::vector<CharacteristicZero> characteristic_zeros(const LinearTransform& transform) {
  std::vector<CharacteristicZero> zeros;
  if (!transform.characteristic.empty() && transform.characteristic.begin()->first > 0)
    zeros.push_back({.s = 0.0});
  for (const auto& zero : zeros_about_strip(transform)) {
    const long double beyond = std::abs(zero.log.imag()) - pi_long;
    const bool on_cut = std::abs(beyond) <= width_of_cut(zero);  // there on both sides, as its conjugate
    if (on_cut && zero.log.imag() > 0.0L)
      zeros.push_back({static_cast<double>(-std::exp(zero.log.real())), zero.multiplicity});
    if (!on_cut && beyond < 0.0L)
      zeros.push_back({std::complex<double>(std::exp(zero.log)), zero.multiplicity});
  }
  std::ranges::sort(zeros, [](const CharacteristicZero& a, const CharacteristicZero& b) {
    return std::pair(-a.s.real(), -a.s.imag()) < std::pair(-b.s.real(), -b.s.imag());
  });
  return zeros;
}

}  // namespace fde::reference
