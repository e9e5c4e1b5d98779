// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <exception>
#include <iterator>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "fdebench/benchmarks/references/reference_of.hpp"
#include "fdebench/reports/analysis/text.hpp"
#include "fdebench/reports/page/page_data.hpp"

namespace fde::bench {
namespace {

constexpr double largest_share = 0.1;
constexpr auto errors_at_end = "error at the end", errors_over_all = "largest error over all times";

// The smallest error of a scene in one norm, the bound of the reference, and their ratio: three cells, empty
// if no run has both.
std::vector<Cell> reference_cells(const PageInput& page, RunSpan scene, std::string_view error_id,
                                  std::string_view bound_id) {
  const MeasuredRun* best = nullptr;
  for (const MeasuredRun& run : scene) {
    if (run[error_id] && run[bound_id] && (best == nullptr || *run[error_id] < *(*best)[error_id]))
      best = &run;
  }
  if (best == nullptr) return std::vector<Cell>(3);
  const double error = *(*best)[error_id], bound = *(*best)[bound_id];
  Cell share{.text = error > 0.0 ? error_text(bound / error) : "the error is 0"};
  if (bound > largest_share * error) {
    share.highlighted = true;
    share.detail = "not resolved by the reference";
  }
  const std::string label = page.label(best->key);
  return {{.text = error_text(bound)},
          {.text = error_text(error),
           .detail = fmt::format("{}, N = {}", label, count_text(best->steps)),
           .line = label},
          share};
}

// CPU seconds to compute a reference by two methods without the cache, as `fdebench exact` does; nullopt if
// the reference is a formula or cannot be computed.
std::optional<double> seconds_to_compute(Scene scene) {
  if (evidence_of(scene) != "two methods") return std::nullopt;
  scene.name.clear();  // the cache on disk is keyed by the name
  const auto start = std::clock();
  try {
    reference_of(scene);
  } catch (const std::exception&) {
    return std::nullopt;
  }
  return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

struct Basis {
  std::string_view evidence{};
  std::optional<double> seconds{};
};

// Of scenes that differ in their settings only the first is timed.
Basis basis_of(const SceneSettings& settings, bool is_first) {
  const auto scene = known_scene(settings);
  if (!scene) return {};
  return {.evidence = evidence_of(*scene), .seconds = is_first ? seconds_to_compute(*scene) : std::nullopt};
}

// Empty if no run of the scene has an error and a bound.
std::vector<Cell> reference_row(const PageInput& page, RunSpan scene, const Basis& basis) {
  const auto& of = scene.front().key.scene;
  std::vector<Cell> row{{.text = name_of_scene(of).title, .detail = label_of(of)}};
  std::ranges::copy(reference_cells(page, scene, "error_end", "reference_bound"), std::back_inserter(row));
  std::ranges::copy(reference_cells(page, scene, "error_maximum", "reference_bound_maximum"),
                    std::back_inserter(row));
  const bool known =
      std::any_of(row.begin() + 1, row.end(), [](const Cell& cell) { return !cell.text.empty(); });
  if (!known) return {};
  row.insert(row.begin() + 1,
             {.text = std::string(basis.evidence),
              .detail = basis.seconds ? "computed in " + time_text(*basis.seconds) : std::string()});
  return row;
}

constexpr ErrorKind judged{.norm = Norm::maximum, .scale = Scale::mixed};
constexpr double fine = 1e-12;

bool takes_accuracy(const RecommendedRun& option) {
  return std::holds_alternative<Tolerance>(option.setup.resolution);
}

// The time of the quickest plain scheme on a grid within 1e-12, extrapolated by the error model if no run
// reaches it. Plain: without starting weights, hence with a low rate.
struct PlainSchemeTime {
  double seconds = INFINITY;
  bool is_forecast = false;
};

PlainSchemeTime over_grid(const SceneLines& lines, RunSpan runs) {
  const auto is_plain = [&](const RecommendedRun& option) {
    return !takes_accuracy(option) && std::ranges::none_of(runs, [&](const MeasuredRun& run) {
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

// Times to compute the references, and times of schemes with a comparable accuracy; empty if nothing is
// timed.
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

  [[nodiscard]] std::string text() const {
    if (computed_.empty()) return {};
    const auto [least, most] = std::ranges::minmax(computed_);
    std::string said = fmt::format(
        "Where two methods have to agree, a reference took {} to {} of a processor when it was recomputed "
        "for this page, as fdebench exact does.",
        time_text(least), time_text(most));
    if (!ratios_.empty()) {
      said += fmt::format(
          " The quickest scheme over a grid without start weights takes {} times as long to an error of "
          "1e-12, "
          "in the median of {} scenes{}.",
          rough_count_text(middle(ratios_)), ratios_.size(),
          forecasts_ > 0 ? fmt::format(", for {} of them by its errors so far", forecasts_) : "");
    }
    if (!choosing_.empty()) {
      said += fmt::format(
          " The quickest that takes an accuracy gets there in {}, in the median of the {} "
          "where one was measured.",
          time_text(middle(choosing_)), choosing_.size());
    }
    return said;
  }

 private:
  std::vector<double> computed_{}, ratios_{}, choosing_{};
  int forecasts_ = 0;
};

}  // namespace

Section reference_section(const PageInput& page) {
  Section section{
      .id = "reference",
      .title = "How far the reference is known",
      .paragraphs =
          {"An error means something only as far as it is above the error of the reference itself: a bound "
           "where the solution is known in closed form or as an inverse Laplace transform, an estimate where "
           "two methods that share nothing agree. It is set against the smallest error measured on the "
           "scene. "
           "The first of the two methods is a collocation on panels, as spectral_collocation is; for that "
           "scheme the second one vouches alone, exponentials within a Radau IIA method. What is stated "
           "covers the difference of the two; where it is more than a tenth of an error, that is marked."},
      .table = {.caption = "The reference's own error against the smallest error measured",
                .columns = {{"scene"},
                            {"rests on"},
                            {"reference", errors_at_end},
                            {"smallest measured", errors_at_end},
                            {"ratio", errors_at_end},
                            {"reference", errors_over_all},
                            {"smallest measured", errors_over_all},
                            {"ratio", errors_over_all}}}};
  RowGroup rows;
  CostOfReferences cost;
  std::set<std::string> seen;
  for (const RunSpan scene : by_scene(page.runs.finished)) {
    const auto& of = scene.front().key.scene;
    const Basis basis = basis_of(of, seen.insert(of.id).second);
    if (basis.seconds) cost.add(SceneLines(page.runs, of), scene, *basis.seconds);
    if (auto cells = reference_row(page, scene, basis); !cells.empty()) rows.rows.push_back(std::move(cells));
  }
  if (!rows.rows.empty()) section.table.groups.push_back(std::move(rows));
  if (auto text = cost.text(); !text.empty()) section.paragraphs.push_back(std::move(text));
  return section;
}

}  // namespace fde::bench
