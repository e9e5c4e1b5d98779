// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/requests/judged_trajectory.hpp"

#include <fmt/format.h>

#include <memory>
#include <utility>

#include "fdebench/benchmarks/measures/measures.hpp"
#include "fdebench/benchmarks/records/record_validation.hpp"
#include "fdebench/benchmarks/references/memoized_reference.hpp"
#include "fdebench/benchmarks/scenes/start_time.hpp"
#include "fdebench/benchmarks/sweep/described_scene.hpp"
#include "fdebench/benchmarks/text/refusal.hpp"

namespace fde::bench {
namespace {

// Sets the end of the scene to the last time of the trajectory, so that the error at the end is at that time.
// The solution of a two-sided problem depends on its end.
void end_with(const ExternalTrajectory& path, SceneVariant& variant, Scene& scene) {
  const double last = path.times.back(), end = scene.problem.end;
  if (last == end) return;
  if (is_two_sided(scene.problem)) {
    throw Refusal(
        {RequestField{"trajectory"}, fmt::format(": ends at t = {}, scene {} is posed at both ends, 0 and {}",
                                                 last, variant.factory->id, end)});
  }
  variant.until = last;
  set_end(scene, last);
}

// A run without an assessment. The settings of the other program are unknown.
Record run_of(const SceneVariant& scene, const std::string& name, const ExternalTrajectory& path) {
  const auto steps = static_cast<int>(path.times.size());
  return {.key = {.scene = scene.key(), .scheme = name, .settings = {.resolution = steps}, .external = true},
          .steps = steps,
          .end = path.times.back(),
          .program = path.report.facts};
}

}  // namespace

JudgedTrajectory judge(const JudgeRequest& request) {
  SceneVariant variant = request.variant;
  const auto scene = std::make_shared<Scene>(make_scene(variant));
  require_start_at_zero(*scene, "judge");
  if (request.name) require_external_name("name", *request.name);
  for (const double duration : request.seconds) require_in("seconds", duration, positive);
  const auto path = request.trajectory(*scene);
  end_with(path, variant, *scene);
  const auto reference = std::make_shared<MemoizedReference>(*scene);
  const auto compared = at_comparison_times(path);
  const auto judgement = judge_trajectory(*scene, compared, *reference);
  Record run = assessed(run_of(variant, request.name.value_or(""), path), judgement);
  const auto& seconds = request.seconds.empty() ? path.report.seconds : request.seconds;
  if (!seconds.empty() && is_compared(run.ending.kind)) run.timing = timing_of({.seconds = seconds});
  std::optional<ChiSquared> fits;
  if (path.deviations.size() > 0 && path.values.allFinite())
    fits = chi_squared(compared, reference->at(compared.times)(compared.columns, Eigen::all), 0);
  return {std::move(run), [=] { return describe(variant, *scene, *reference); }, fits};
}

}  // namespace fde::bench
