// SPDX-License-Identifier: MIT
#include "fdebench/reports/command/requested_sweep.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <utility>

#include "fdebench/benchmarks/requests/sweep_request.hpp"
#include "fdebench/benchmarks/study/study.hpp"
#include "fdebench/benchmarks/sweep/shard.hpp"
#include "fdebench/benchmarks/text/number_text.hpp"

namespace fde::bench {
namespace {

std::vector<SceneVariant> chosen_scenes(const Given& given, const SceneRegistry& known) {
  const auto &texts = given.all("--scene"), &settings = given.all("--set");
  if (texts.empty() && !settings.empty()) reject_text("--set", settings.front(), "with --scene");
  std::vector<SceneVariant> variants;
  for (const auto& text : texts)
    std::ranges::copy(parse_variants(text, settings, known), std::back_inserter(variants));
  return variants;
}

std::vector<StepsOrTolerance> chosen_resolutions(const Given& given) {
  const auto texts = [&](const char* name) {
    return given.has(name) ? split_list(given.text(name)) : std::vector<std::string>{};
  };
  std::vector<StepsOrTolerance> chosen;
  for (const auto& text : texts("--steps"))
    chosen.emplace_back(parse_count("--steps", text, step_counts.lowest, step_counts.highest));
  for (const auto& text : texts("--accuracy")) chosen.emplace_back(parse_accuracy(text));
  return chosen;
}

SweepRequest request_of(const Given& given, const SceneRegistry& known) {
  SweepRequest request{.scenes = chosen_scenes(given, known),
                       .resolutions = chosen_resolutions(given),
                       .settings = parse_run_settings(given),
                       .optimal_grading = given.text("--grid") == optimal_grid,
                       .budget = given.find_number("--budget"),
                       .repeats = given.count("--repeat"),
                       .thorough = given.has("--thorough"),
                       .trials = given.has("--trials"),
                       .examine = given.has("--examine"),
                       .undisturbed = given.has("--undisturbed")};
  for (const auto& id : given.all("--scheme")) request.schemes.push_back(&scheme_named(id));
  for (const auto& text : given.all("--external")) request.programs.push_back(parse_external(text));
  return request;
}

}  // namespace

std::string budget_of_sweeps_text() {
  return fmt::format("{} with --steps or --accuracy, {} with --thorough, otherwise {}", budget_of_listed_runs,
                     budget_of_thorough_runs, budget_of_search);
}

std::vector<Sweep> sweeps_of(const Given& given, const SceneRegistry& known) {
  const auto study = given.find("--study"), shard = given.find("--shard");
  try {
    auto sweeps =
        study ? sweeps_of(read_study(*study, known), given.has("--examine"), given.has("--undisturbed"))
              : sweeps_of(request_of(given, known));
    return shard ? shard_of(std::move(sweeps), parse_shard(*shard)) : sweeps;
  } catch (const Refusal& refusal) {
    given.refuse(refusal);
  }
}

bool count_is_exact(const std::vector<Sweep>& sweeps) {
  return std::ranges::none_of(sweeps, [](const auto& sweep) { return sweep.plan.goal.has_value(); });
}

}  // namespace fde::bench
