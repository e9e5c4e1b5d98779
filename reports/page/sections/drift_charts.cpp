// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <exception>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "fdebench/benchmarks/observers/independent_memory.hpp"
#include "fdebench/benchmarks/scenes/variant.hpp"
#include "fdebench/reports/analysis/formulations.hpp"
#include "fdebench/reports/page/chart_number.hpp"
#include "fdebench/reports/page/page_data.hpp"

namespace fde::bench {
namespace {

using nlohmann::json;

constexpr int digits = 3;
constexpr int times_an_octave = 8, octaves = 10;

// The running maximum of the drift, sampled at eight times per factor of 2 in t, from end/1024 on.
class RunningMaximum {
 public:
  explicit RunningMaximum(double end) : next_(std::ldexp(end, -octaves)) {}

  void observe(double t, double drift) {
    largest_ = std::max(largest_, drift);
    if (t < next_ * (1.0 - 1e-12)) return;
    if (largest_ > 0.0) {
      t_.push_back(rounded_for_chart(t, digits));
      drift_.push_back(rounded_for_chart(largest_, digits));
    }
    while (next_ * (1.0 - 1e-12) <= t) next_ *= std::exp2(1.0 / times_an_octave);
  }

  void add_to(json& shown) const {
    shown["t"] = t_;
    shown["drift"] = drift_;
  }

 private:
  double next_, largest_ = 0.0;
  std::vector<double> t_{}, drift_{};
};

// The columns at the steps of a run. D^order of the velocities is computed by a rule other than the scheme's
// where that is possible (IndependentMemoryRule).
class IndependentColumns {
 public:
  IndependentColumns(const Scene& scene, const Grid& grid, Matrix columns)
      : scene_(scene), columns_(std::move(columns)) {
    if (!grid.uniform() || grid.steps < IndependentMemoryRule::fewest_steps) return;
    for (const auto& [derivative, velocity, order, powers] : scene.memory_columns)
      memories_.emplace_back(grid, order, powers);
  }

  // Whether at() is expensive: it then computes a history sum.
  [[nodiscard]] bool is_expensive() const { return !memories_.empty(); }

  [[nodiscard]] Vec at(int step) const {
    Vec seen = columns_.col(step);
    for (std::size_t m = 0; m < memories_.size(); ++m) {
      const MemoryColumn& of = scene_.memory_columns[m];
      seen[of.derivative] = memories_[m].at(step, columns_.row(of.velocity).transpose());
    }
    return seen;
  }

 private:
  const Scene& scene_;
  Matrix columns_;
  std::vector<IndependentMemoryRule> memories_{};
};

// The drift of the run as a function of t, from a new solve; nullopt if the solve does not finish.
std::optional<json> course_of(const PageInput& page, const BestInTime& best) {
  const RunKey& key = best.run.key;
  const auto* maker = find_scene(key.scene.id);
  const auto* scheme = find_scheme(key.scheme);
  const auto* steps = std::get_if<int>(&key.setup.resolution);
  if (maker == nullptr || scheme == nullptr || steps == nullptr || !key.scene.checksum.empty())
    return std::nullopt;
  const Scene scene = make_scene(SceneVariant{maker, key.scene.values, key.scene.until});
  const Grid grid{.end = scene.problem.end, .steps = *steps, .grading = key.setup.grading};
  const Trajectory path = scheme->solve(scene.problem, grid, key.setup.options());
  if (path.status != SolveStatus::finished || path.y.cols() != *steps + 1) return std::nullopt;
  const IndependentColumns columns(scene, grid, columns_of(scene.outputs, path));
  RunningMaximum largest(grid.end);
  double next = 0.0;
  for (int n = 1; n <= *steps; ++n) {
    const double t = grid.time(n);
    if (columns.is_expensive() && t < next && n < *steps) continue;
    next = t * std::exp2(1.0 / times_an_octave);
    largest.observe(t, scene.constraint.drift(t, columns.at(n)));
  }
  json course{{"formulation", best.formulation}, {"line", page.label(key)}, {"steps", *steps}};
  largest.add_to(course);
  return course;
}

json courses_of(const PageInput& page, const ConstrainedScene& scene) {
  json courses = json::array();
  for (const auto& best : best_in_time(scene).ranked) {
    try {
      if (auto course = course_of(page, best)) courses.push_back(std::move(*course));
    } catch (const std::exception&) {  // this build cannot solve the scene: no curve
      continue;
    }
  }
  return courses;
}

// Index of a name in a list; appends the name if it is new.
std::size_t place_in(std::vector<std::string>& names, const std::string& name) {
  const auto found = static_cast<std::size_t>(std::ranges::find(names, name) - names.begin());
  if (found == names.size()) names.push_back(name);
  return found;
}

// Columns of equal length with one entry per run.
json points_of(const PageInput& page, const ConstrainedScene& scene) {
  std::vector<std::string> formulations, lines;
  json points;
  for (const auto& of : scene.formulations) {
    for (const MeasuredRun& run : of.runs) {
      const double drift = effective_drift(run);
      if (!(drift > 0.0) || !std::isfinite(drift)) continue;
      points["formulation"].push_back(place_in(formulations, of.formulation));
      points["line"].push_back(place_in(lines, page.label(run.key)));
      points["steps"].push_back(run.steps);
      points["h"].push_back(rounded_for_chart(run.h));
      points["drift"].push_back(rounded_for_chart(drift, digits));
    }
  }
  points["formulations"] = formulations;
  points["lines"] = lines;
  return points;
}

}  // namespace

json drift_charts(const PageInput& page, const ConstrainedScene& scene) {
  return {{"id", section_of(scene.scene)},
          {"title", name_of_scene(scene.scene).title},
          {"points", points_of(page, scene)},
          {"courses", courses_of(page, scene)}};
}

}  // namespace fde::bench
