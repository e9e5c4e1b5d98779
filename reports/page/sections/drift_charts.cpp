// SPDX-License-Identifier: MIT
#include <cmath>
#include <nlohmann/json.hpp>

#include "fdebench/reports/analysis/formulations.hpp"
#include "fdebench/reports/page/facts.hpp"

namespace fde::bench {
namespace {

using nlohmann::json;

// The drift of effective_drift() up to t; empty if the run has none.
Course course_of(const Record& run) {
  for (const auto* quantity : {"drift_independent", "drift_internal"}) {
    const auto found = run.courses.find(quantity);
    if (found != run.courses.end()) return found->second;
  }
  return {};
}

json courses_of(const PageInput& page, const ConstrainedScene& scene) {
  json courses = json::array();
  for (const auto& [formulation, run] : best_in_time(scene).ranked) {
    const Course course = course_of(run);
    if (course.empty()) continue;
    courses.push_back({{"formulation", formulation},
                       {"line", page.label(run.key)},
                       {"steps", run.steps},
                       {"t", course.t},
                       {"drift", course.value}});
  }
  return courses;
}

// Columns of equal length with one entry per run.
json points_of(const PageInput& page, const ConstrainedScene& scene) {
  Places formulations, lines;
  json points;
  for (const auto& of : scene.formulations) {
    for (const Record& run : of.runs) {
      const double drift = effective_drift(run);
      if (!(drift > 0.0) || !std::isfinite(drift)) continue;
      points["formulation"].push_back(formulations(of.formulation));
      points["line"].push_back(lines(page.label(run.key)));
      points["steps"].push_back(run.steps);
      points["h"].push_back(chart_number(run.h()));
      points["drift"].push_back(chart_number(drift, few_digits));
    }
  }
  points["formulations"] = formulations.texts();
  points["lines"] = lines.texts();
  return points;
}

}  // namespace

json drift_charts(const PageInput& page, const ConstrainedScene& scene) {
  return {{"id", section_of(scene.scene)},
          {"title", name_of_scene(page, scene.scene).title},
          {"points", points_of(page, scene)},
          {"courses", courses_of(page, scene)}};
}

}  // namespace fde::bench
