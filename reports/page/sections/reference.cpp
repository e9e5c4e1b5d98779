// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string_view>
#include <variant>
#include <vector>

#include "fdebench/reports/page/facts.hpp"

namespace fde::bench {
namespace {

using nlohmann::json;

constexpr double largest_share = 0.1;

// The smallest error of a scene in one norm with the bound of the reference, and their ratio; null if no run
// has both.
json best_resolved(const PageInput& page, RunSpan scene, std::string_view error_id,
                   std::string_view bound_id) {
  const Record* best = nullptr;
  for (const Record& run : scene) {
    if (run[error_id] && run[bound_id] && (best == nullptr || *run[error_id] < *(*best)[error_id]))
      best = &run;
  }
  if (best == nullptr) return {};
  const double error = *(*best)[error_id], bound = *(*best)[bound_id];
  json facts = run_facts(page, *best, {});
  facts.update({{"error", fact(error)},
                {"bound", fact(bound)},
                {"ratio", error > 0.0 ? fact(bound / error) : json()},
                {"unresolved", bound > largest_share * error}});
  return facts;
}

// null if no run of the scene has an error and a bound.
json reference_row(const PageInput& page, RunSpan scene, const SceneDescription& described) {
  const auto& of = scene.front().key.scene;
  json end = best_resolved(page, scene, "error_end", "reference_bound"),
       maximum = best_resolved(page, scene, "error_maximum", "reference_bound_maximum");
  if (end.is_null() && maximum.is_null()) return {};
  return {{"title", name_of_scene(page, of).title},
          {"name", label_of(of)},
          {"evidence", described.evidence},
          {"seconds", fact(described.reference_seconds)},
          {"end", std::move(end)},
          {"maximum", std::move(maximum)}};
}

constexpr ErrorKind judged{.norm = Norm::maximum, .scale = Scale::mixed};
constexpr double fine = 1e-12;

bool takes_accuracy(const RecommendedRun& option) {
  return std::holds_alternative<Tolerance>(option.settings.resolution);
}

// The time of the quickest plain scheme on a grid within 1e-12, extrapolated by the error model if no run
// reaches it. Plain: without starting weights, hence with a low rate.
struct PlainSchemeTime {
  double seconds = INFINITY;
  bool is_forecast = false;
};

PlainSchemeTime over_grid(const SceneLines& lines, RunSpan runs) {
  const auto is_plain = [&](const RecommendedRun& option) {
    return !takes_accuracy(option) && std::ranges::none_of(runs, [&](const Record& run) {
      return run.key.scheme == option.schemes.front() && run["start_weights"];
    });
  };
  PlainSchemeTime best;
  for (const RecommendedRun& option : lines.within(judged, fine)) {
    if (is_plain(option)) best.seconds = std::min(best.seconds, option.time.median);
  }
  if (std::isfinite(best.seconds)) return best;
  best.is_forecast = true;
  for (const ErrorForecast& forecast : lines.forecasts(judged)) {
    const double seconds = forecast.errors.steps(fine).value * forecast.line.seconds_per_step();
    if (is_plain(forecast.line) && seconds > 0.0) best.seconds = std::min(best.seconds, seconds);
  }
  return best;
}

double middle(std::vector<double> values) {
  const auto place = values.begin() + std::ssize(values) / 2;
  std::ranges::nth_element(values, place);
  return *place;
}

// Times to compute the references, and times of schemes with a comparable accuracy.
class CostOfReferences {
 public:
  void add(const SceneLines& lines, RunSpan runs, double seconds) {
    computed_.push_back(seconds);
    for (const RecommendedRun& option : lines.within(judged, fine)) {
      if (!takes_accuracy(option)) continue;
      choosing_.push_back(option.time.median);
      break;
    }
    const PlainSchemeTime grid = over_grid(lines, runs);
    if (!std::isfinite(grid.seconds)) return;
    ratios_.push_back(grid.seconds / seconds);
    forecasts_ += grid.is_forecast ? 1 : 0;
  }

  [[nodiscard]] json facts() const {
    if (computed_.empty()) return {};
    const auto [least, most] = std::ranges::minmax(computed_);
    json all{{"seconds", {fact(least), fact(most)}}};
    if (!ratios_.empty()) {
      all["grid"] = {{"ratio", fact(middle(ratios_))},
                     {"scenes", ratios_.size()},
                     {"forecasts", forecasts_ > 0 ? json(forecasts_) : json()}};
    }
    if (!choosing_.empty())
      all["adaptive"] = {{"seconds", fact(middle(choosing_))}, {"scenes", choosing_.size()}};
    return all;
  }

 private:
  std::vector<double> computed_{}, ratios_{}, choosing_{};
  int forecasts_ = 0;
};

}  // namespace

json reference_section(const PageInput& page) {
  json rows = json::array();
  CostOfReferences cost;
  for (const RunSpan scene : by_scene(page.runs.finished)) {
    const auto& of = scene.front().key.scene;
    const auto* found = page.runs.describe(of);
    const SceneDescription& described = found != nullptr ? *found : SceneDescription{};
    if (described.reference_seconds) cost.add(SceneLines(page.runs, of), scene, *described.reference_seconds);
    if (json row = reference_row(page, scene, described); !row.is_null()) rows.push_back(std::move(row));
  }
  return {{"id", "reference"}, {"cost", cost.facts()}, {"groups", json::array({{{"rows", rows}}})}};
}

}  // namespace fde::bench
