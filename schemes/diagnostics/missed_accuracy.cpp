// SPDX-License-Identifier: MIT
#include "fdebench/schemes/diagnostics/missed_accuracy.hpp"

#include <cmath>

namespace fde {
namespace {

constexpr double looser = 10.0, undecided = 3.0, missed = 5.0;

Tolerance times(const Tolerance& accuracy, double factor) {
  return {.rtol = factor * accuracy.rtol, .atol = factor * accuracy.atol};
}

// The largest |value - other| in units of the tolerance, of which the error of the run is this part.
MissedAccuracy largest_error(const Tolerance& requested, const Rows& values, const Rows& others,
                             double part) {
  MissedAccuracy worst{.times = 0.0, .row = 0, .column = 0};
  for (Eigen::Index c = 0; c < values.cols(); ++c) {
    for (Eigen::Index i = 0; i < values.rows(); ++i) {
      const double allowed = requested.rtol * std::abs(values(i, c)) + requested.atol;
      const double off = part * std::abs(values(i, c) - others(i, c)) / allowed;
      if (std::isfinite(off) && off > worst.times) worst = {.times = off, .row = i, .column = c};
    }
  }
  return worst;
}

}  // namespace

std::optional<MissedAccuracy> missed_accuracy(const Tolerance& requested, const Rows& values,
                                              const OtherRun& other, bool check) {
  std::optional<MissedAccuracy> error;
  if (const auto rough = other(times(requested, looser)))
    error = largest_error(requested, values, *rough, 1.0 / (looser - 1.0));
  if (check || (error && error->times > undecided)) {
    if (const auto fine = other(times(requested, 1.0 / looser)))
      error = largest_error(requested, values, *fine, looser / (looser - 1.0));
  }
  return error && error->times > missed ? error : std::nullopt;
}

}  // namespace fde
