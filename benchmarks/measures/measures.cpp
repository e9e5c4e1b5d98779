#include "measures/measures.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace fde {
namespace {

double minimum(const std::vector<double>& seconds) { return std::ranges::min(seconds); }

double median(const std::vector<double>& seconds) {
  auto values = seconds;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::ranges::nth_element(values, middle);
  return values.size() % 2 == 1 ? *middle : 0.5 * (*middle + *std::max_element(values.begin(), middle));
}

constexpr std::array all_of_time{
    TimeMeasure{"time_minimum", minimum},
    TimeMeasure{"time_median", median},
};

}  // namespace

std::span<const Measure* const> measures() {
  static constexpr std::array all{
#define FDE_MEASURE(id) &measure::id,
#include "measures/list.def"
#undef FDE_MEASURE
  };
  return all;
}

std::span<const TimeMeasure> time_measures() { return all_of_time; }

double error_end(const Rows& values, const Rows& reference) {
  return (values.rightCols(1) - reference.rightCols(1)).cwiseAbs().maxCoeff();
}

double error_maximum(const Rows& values, const Rows& reference) {
  return (values - reference).cwiseAbs().maxCoeff();
}

double mescd(const Rows& values, const Rows& reference) {
  const auto error = (values.rightCols(1) - reference.rightCols(1)).array().abs();
  const double relative = (error / (1.0 + reference.rightCols(1).array().abs())).maxCoeff();
  return -std::log10(std::max(relative, 1e-17));
}

}  // namespace fde
