#include "fdebench/schemes/diagnostics/missed_accuracy.hpp"

#include <cmath>

namespace fde {
namespace {

constexpr double looser = 10.0, in_doubt = 3.0, missed = 5.0;

Tolerance times(const Tolerance& accuracy, double factor) {
  return {.relative = factor * accuracy.relative, .absolute = factor * accuracy.absolute};
}

// The largest |value - other| in units of what was asked, of which the error of the run is this part.
MissedAccuracy largest_error(const Tolerance& asked, const Rows& values, const Rows& others, double part) {
  MissedAccuracy worst{.times = 0.0, .row = 0, .column = 0};
  for (Eigen::Index c = 0; c < values.cols(); ++c) {
    for (Eigen::Index i = 0; i < values.rows(); ++i) {
      const double allowed = asked.relative * std::abs(values(i, c)) + asked.absolute;
      const double off = part * std::abs(values(i, c) - others(i, c)) / allowed;
      if (std::isfinite(off) && off > worst.times) worst = {.times = off, .row = i, .column = c};
    }
  }
  return worst;
}

}  // namespace

std::optional<MissedAccuracy> missed_accuracy(const Tolerance& asked, const Rows& values,
                                              const OtherRun& other, bool check) {
  std::optional<MissedAccuracy> error;
  if (const auto rough = other(times(asked, looser)))
    error = largest_error(asked, values, *rough, 1.0 / (looser - 1.0));
  if (check || (error && error->times > in_doubt)) {
    if (const auto fine = other(times(asked, 1.0 / looser)))
      error = largest_error(asked, values, *fine, looser / (looser - 1.0));
  }
  return error && error->times > missed ? error : std::nullopt;
}

}  // namespace fde
