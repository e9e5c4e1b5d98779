// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/expressions/time_function.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <deque>
#include <limits>
#include <stdexcept>
#include <utility>

namespace fde::bench {
namespace {

// -1, 0 or 1; NaN of NaN.
double sign(double value) { return value > 0.0 ? 1.0 : value < 0.0 ? -1.0 : value; }

}  // namespace

TimeFunction::TimeFunction(Expression of, ExpressionPool& pool) : value_(pool, {of}, 0) {
  // Derivatives leave out what a step, a sign or a table adds where it jumps.
  if (!pool.arguments({of}, jumps).empty()) return;
  try {
    slope_ = Program(pool, {pool.derivative(of, 0)}, 0);
  } catch (const std::invalid_argument&) {
    slope_.reset();
  }
}

double TimeFunction::largest(double from, double to) const {
  const double size = value_.range({from, to}).magnitude();
  return std::isfinite(size) ? size : 0.0;
}

std::optional<double> TimeFunction::sign_on(double from, double to, double negligible) const {
  const Interval value = value_.range({from, to});
  if (value.magnitude() <= negligible) return 0.0;
  if (value.low > -negligible) return 1.0;
  if (value.high < negligible) return -1.0;
  return std::nullopt;
}

bool TimeFunction::is_monotone_on(double from, double to) const {
  if (!slope_) return false;
  const Interval slope = slope_->range({from, to});
  return slope.low >= 0.0 || slope.high <= 0.0;
}

// As one piece, or as two of different signs.
void TimeFunction::add_by_ends(double from, double to, std::vector<SignedPiece>& found) const {
  const double before = sign((*this)(from)), after = sign((*this)(to));
  if (!(before < after || before > after)) return found.push_back({from, to, before});
  double low = from, high = to;
  for (;;) {
    const double middle = low + (high - low) / 2.0;
    if (middle <= low || middle >= high) break;
    (sign((*this)(middle)) == before ? low : high) = middle;
  }
  found.push_back({from, high, before});
  found.push_back({high, to, after});
}

std::vector<SignedPiece> TimeFunction::signs(double from, double to, double negligible) const {
  constexpr std::size_t most_pieces = std::size_t{1} << 16;
  constexpr double shortest = 8.0 * std::numeric_limits<double>::epsilon();
  std::deque<std::pair<double, double>> open{{from, to}};
  std::vector<SignedPiece> found;
  for (std::size_t pieces = 1; !open.empty();) {
    const auto [low, high] = open.front();
    open.pop_front();
    const double middle = low + (high - low) / 2.0;
    if (const auto known = sign_on(low, high, negligible)) {
      found.push_back({low, high, *known});
    } else if (pieces >= most_pieces || high - low <= shortest * high || is_monotone_on(low, high)) {
      add_by_ends(low, high, found);
    } else {
      open.emplace_back(low, middle);
      open.emplace_back(middle, high);
      ++pieces;
    }
  }
  std::erase_if(found, [](const SignedPiece& piece) { return std::isnan(piece.sign); });
  std::ranges::sort(found, {}, &SignedPiece::from);
  std::vector<SignedPiece> merged;
  for (const auto& piece : found) {
    if (!merged.empty() && merged.back().sign == piece.sign) {
      merged.back().to = piece.to;
    } else {
      merged.push_back(piece);
    }
  }
  return merged;
}

}  // namespace fde::bench
