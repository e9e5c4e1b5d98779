// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/requests/recommendation.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <string_view>

#include "fdebench/benchmarks/text/output_text.hpp"
#include "fdebench/benchmarks/text/printable.hpp"

namespace fde::bench {
namespace {

bool same_scheme(const RecommendedRun& a, const RecommendedRun& b) { return a.schemes == b.schemes; }

bool meet(const MedianInterval& a, const MedianInterval& b) { return a.low <= b.high && b.low <= a.high; }

std::string way_text(const Configuration& configuration, int steps) {
  const auto grid = configuration.grading == 1.0 ? "" : ", " + grid_text(configuration.grading);
  return fmt::format("{}{} with N = {}", configuration.scheme->id, grid, count_text(steps));
}

}  // namespace

std::vector<SmallColumn> small_columns(const ErrorKind& kind, double accuracy,
                                       const std::vector<std::string>& names,
                                       const std::vector<double>& largest) {
  constexpr double part = 0.1;
  std::vector<SmallColumn> small;
  if (kind.scale == Scale::relative || kind.scale == Scale::peak) return small;
  for (std::size_t i = 0; i < names.size(); ++i) {
    const double allowed = accuracy * (kind.scale == Scale::mixed ? 1.0 + largest[i] : 1.0);
    if (largest[i] > 0.0 && allowed > part * largest[i]) small.push_back({names[i], largest[i], allowed});
  }
  return small;
}

std::string_view error_word(const Recommendation& made) {
  return made.estimate ? "estimated error" : "error";
}

std::vector<std::string> within_noise(const Recommendation& made) {
  std::vector<std::string> names;
  const RecommendedRun& first = made.options.front();
  for (const RecommendedRun& option : made.options) {
    if (same_scheme(option, first) || !meet(option.time, first.time)) continue;
    if (std::ranges::find(names, option.schemes.front()) == names.end())
      names.push_back(option.schemes.front());
  }
  return names;
}

const RecommendedRun* runner_up(const Recommendation& made) {
  const auto is_other = [&](const RecommendedRun& option) {
    return !same_scheme(option, made.options.front());
  };
  const auto found = std::ranges::find_if(made.options, is_other);
  if (found != made.options.end()) return &*found;
  return made.expected.empty() ? nullptr : &made.expected.front();
}

std::string estimate_text(const ErrorEstimate& estimate) {
  return fmt::format(
      "errors are estimated, not verified: there is no reference ({}); in its place {} is used, which {} "
      "differs from by {}, so it is taken to be off by {}, which counts as error",
      estimate.no_reference_reason, way_text(estimate.first, estimate.first_steps),
      way_text(estimate.second, estimate.second_steps), error_text(estimate.difference),
      error_text(estimate.error()));
}

std::string kind_text(const ErrorKind& kind) {
  const auto* where = kind.norm == Norm::end ? "at the end" : "maximum over all steps";
  return fmt::format("{}, {} scale", where, name(kind.scale));
}

}  // namespace fde::bench
