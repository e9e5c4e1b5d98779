// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <optional>
#include <string>

#include "fdebench/reports/analysis/text.hpp"
#include "fdebench/reports/page/page_data.hpp"

namespace fde::bench {
namespace {

std::optional<double> observed_rate_of(const PageInput& page, const SceneSettings& scene,
                                       const RecommendedRun& line, Norm norm) {
  for (const RateRow& row : page.rates) {
    if (row.scene != scene || row.scheme != line.schemes.front() || !same_series(row.setup, line.setup))
      continue;
    const NormRate& rate = norm == Norm::end ? row.end : row.maximum;
    if (rate.fit.points > 0) return rate.fit.slope;
  }
  return std::nullopt;
}

}  // namespace

// Time = steps * time per step: says which factor distinguishes the first line from the second.
std::string reason_for_speed(const PageInput& page, const SceneSettings& scene, const RecommendedRun& first,
                             const RecommendedRun& second, Norm norm) {
  const double fewer = static_cast<double>(second.steps) / first.steps;
  const double dearer = first.seconds_per_step() / second.seconds_per_step();
  const auto name = page.label(second);
  if (fewer < 1.5) {
    return fmt::format("a step takes {} where one of {} takes {}", time_text(first.seconds_per_step()), name,
                       time_text(second.seconds_per_step()));
  }
  std::string text = fmt::format("{} steps are enough where {} needs {}", count_text(first.steps), name,
                                 count_text(second.steps));
  const auto ours = observed_rate_of(page, scene, first, norm),
             theirs = observed_rate_of(page, scene, second, norm);
  if (ours && theirs && *ours > *theirs + 0.2)
    text += fmt::format(", by its rate, {:.1f} against {:.1f}", *ours, *theirs);
  if (dearer > 1.5) text += fmt::format(", although a step takes {:.1f} times as long", dearer);
  return text;
}

}  // namespace fde::bench
