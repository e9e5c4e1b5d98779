// SPDX-License-Identifier: MIT
#include "fdebench/reference/special_functions/laplace/separate_contours.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "fdebench/reference/special_functions/numbers/constants.hpp"

namespace fde::reference {
namespace {

using Point = EnclosingContour::Point;
using Long = long double;
using Group = std::vector<Point>;

// Groups by ascending height, at least `gap` apart.
std::vector<Group> groups_of(Group singularities, Long gap) {
  std::ranges::sort(singularities, {}, [](const Point& s) { return s.imag(); });
  std::vector<Group> groups;
  for (const Point& s : singularities) {
    if (groups.empty() || s.imag() - groups.back().back().imag() >= gap) groups.emplace_back();
    groups.back().push_back(s);
  }
  return groups;
}

void require_resolved(const Group& singularities) {
  constexpr Long highest = 1e8L;
  for (const Point& s : singularities) {
    if (std::abs(s.imag()) > highest) {
      throw std::runtime_error(
          fmt::format("the singularity {:.6g} {:+.6g} i is too far from the real axis", s.real(), s.imag()));
    }
  }
}

bool overlap(const EnclosingContour& lower, const EnclosingContour& upper) {
  return upper.height() - lower.height() < lower.half_width() + upper.half_width();
}

}  // namespace

std::vector<EnclosingContour> separate_contours(const std::vector<Point>& singularities, int digits,
                                                const EnclosingContour::Hints& hints) {
  Long sigma = -infinity_long;
  for (const Point& s : singularities) sigma = std::max(sigma, s.real());
  Group enclosed = singularities;
  const auto split = std::partition(enclosed.begin(), enclosed.end(), [&](const Point& s) {
    return EnclosingContour::is_relevant(s, sigma, digits, hints);
  });
  Group others(split, enclosed.end());
  enclosed.erase(split, enclosed.end());
  require_resolved(enclosed);
  Long gap = 2.0L * EnclosingContour({Point(0.0L)}, digits, hints).half_width();
  for (;;) {
    std::vector<EnclosingContour> contours;
    for (const Group& group : groups_of(enclosed, gap)) contours.emplace_back(group, digits, hints);
    const auto reached = std::partition(others.begin(), others.end(), [&](const Point& s) {
      return std::ranges::none_of(contours, [&](const auto& x) { return x.is_near_rectangle(s); });
    });
    if (reached != others.end()) {
      enclosed.insert(enclosed.end(), reached, others.end());
      others.erase(reached, others.end());
    } else if (std::ranges::adjacent_find(contours, overlap) == contours.end()) {
      return contours;
    } else {
      gap *= 2.0L;
    }
  }
}

}  // namespace fde::reference
