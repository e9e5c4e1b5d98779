// SPDX-License-Identifier: MIT
#include "fdebench/reports/command/requested_sweep.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>
#include <stdexcept>
#include <utility>

#include "fdebench/benchmarks/sweep/default_sweep.hpp"
#include "fdebench/benchmarks/sweep/shard.hpp"
#include "fdebench/benchmarks/sweep/trials.hpp"
#include "fdebench/benchmarks/text/number_text.hpp"
#include "fdebench/reports/command/command.hpp"

namespace fde::bench {
namespace {

constexpr TimingRepeats of_default_sweep{.min_seconds = 0.002, .enough_seconds = 0.03};

// Budgets of a run in seconds: with --steps or --accuracy; in a thorough sweep; otherwise. Schemes with
// adaptive step size may need very many steps on unsuitable problems.
constexpr double usual_budget = 600.0, thorough_budget = 60.0, budget_of_search = 1.0;

bool is_listed(const Given& given) { return given.has("--steps") || given.has("--accuracy"); }

std::vector<SceneVariant> chosen_scenes(const Given& given, const SceneRegistry& known) {
  const auto &texts = given.all("--scene"), &settings = given.all("--set");
  if (texts.empty() && !settings.empty()) reject_text("--set", settings.front(), "with --scene");
  if (texts.empty()) return sweep_scenes();
  std::vector<SceneVariant> variants;
  for (const auto& text : texts)
    std::ranges::copy(parse_variants(text, settings, known), std::back_inserter(variants));
  return variants;
}

// The named schemes. If none is named: all, or none if external programs are given.
std::vector<const Scheme*> chosen_schemes(const Given& given) {
  if (!given.has("--scheme")) return given.has("--external") ? std::vector<const Scheme*>{} : sweep_schemes();
  std::vector<const Scheme*> entries;
  for (const auto& id : given.all("--scheme")) entries.push_back(&scheme_named(id));
  return entries;
}

std::vector<ExternalProgram> chosen_programs(const Given& given) {
  std::vector<ExternalProgram> programs;
  for (const auto& text : given.all("--external")) {
    programs.push_back(parse_external(text));
    const auto& name = programs.back().name;
    if (std::ranges::count(programs, name, &ExternalProgram::name) > 1)
      reject_text("--external", text, "a name that no other program has");
  }
  if (!programs.empty() && given.has("--accuracy"))
    given.refuse("--accuracy", "without --external, whose programs take --steps");
  return programs;
}

// The requested numbers of steps and tolerances; by default default_plan() or thorough_plan().
SweepPlan chosen_plan(const Given& given) {
  if (!is_listed(given)) return given.has("--thorough") ? thorough_plan() : default_plan();
  SweepPlan chosen;
  const auto texts = [&](const char* name) {
    return given.has(name) ? split_list(given.text(name)) : std::vector<std::string>{};
  };
  for (const auto& text : texts("--steps"))
    chosen.resolutions.emplace_back(parse_count("--steps", text, step_counts.lowest, step_counts.highest));
  for (const auto& text : texts("--accuracy")) chosen.resolutions.emplace_back(parse_accuracy(text));
  return chosen;
}

Sweep sweep_of(const Given& given, std::vector<SceneVariant> scenes) {
  const auto grid = given.text("--grid");
  Sweep sweep{.scenes = std::move(scenes),
              .schemes = chosen_schemes(given),
              .programs = chosen_programs(given),
              .plan = chosen_plan(given),
              .settings = parse_run_settings(given),
              .optimal_grids = grid == optimal_grid};
  if (given.has("--accuracy") && !given.has("--steps") && grid != uniform_grid)
    given.refuse("--grid", "with --steps: schemes that take --accuracy choose their times");
  if (sweep.optimal_grids && !sweep.programs.empty())
    given.refuse("--grid", "uniform or graded:R beside --external");
  if (sweep.plan.goal) sweep.repeats = of_default_sweep;
  if (!given.has("--budget")) {
    sweep.settings.budget = is_listed(given)  ? usual_budget
                            : sweep.plan.goal ? budget_of_search
                                              : thorough_budget;
  }
  sweep.repeats.most = given.count("--repeat");
  return sweep;
}

// The sweeps of the options, without those of a study.
std::vector<Sweep> listed_sweeps(const Given& given, const SceneRegistry& known) {
  const bool listed = is_listed(given), has_scenes = given.has("--scene"), trials = given.has("--trials"),
             thorough = given.has("--thorough");
  if (trials && (listed || has_scenes))
    throw std::invalid_argument("--trials = yes: must be without --scene and --steps, trials have their own");
  if (thorough && listed)
    throw std::invalid_argument("--thorough = yes: must be without --steps and --accuracy, it has its own");
  Sweep sweep = sweep_of(given, chosen_scenes(given, known));
  std::vector<Sweep> sweeps;
  if (trials || (!listed && !has_scenes)) sweeps = sweeps_of_trials(sweep, thorough);
  const bool whole = !listed && !has_scenes && !given.has("--scheme");
  if (whole && given.text("--grid") == uniform_grid) sweep.graded = graded_schemes();
  if (!trials) sweeps.push_back(std::move(sweep));
  return sweeps;
}

// Timings that are left out, or repeated where they are disturbed, need runs that do not depend on times.
void set_timing(bool examine, bool undisturbed, Sweep& sweep) {
  constexpr int attempts = 3;
  constexpr auto allowed = "with numbers of steps or tolerances: otherwise times decide which runs are made";
  if (examine && sweep.plan.goal) reject_text("--examine", "yes", allowed);
  if (undisturbed && sweep.plan.goal) reject_text("--undisturbed", "yes", allowed);
  if (examine && undisturbed) reject_text("--undisturbed", "yes", "without --examine, which times nothing");
  sweep.examines_only = examine;
  sweep.retimes = undisturbed;
  if (undisturbed) sweep.repeats.attempts = attempts;
}

// The options of `run` that the settings of a family stand for.
Given given_of(const StudySettings& settings) {
  Given given(run_command().text);
  for (const auto& [key, setting] : settings) {
    const auto& option = std::ranges::find(study_keys, key, &StudyKey::key)->option;
    const bool is_repeated = option == "--scheme" || option == "--external";
    given.set(std::string(option),
              is_repeated ? setting.texts : std::vector{fmt::format("{}", fmt::join(setting.texts, ","))});
  }
  return given;
}

// The message names an option, or a scheme: it gets the place and the name of the key.
[[noreturn]] void reject_setting(const Study& study, const StudyFamily& family, std::string message) {
  for (const auto& [key, option, is_text, is_list] : study_keys) {
    const auto setting = family.settings.find(std::string(key));
    if (setting == family.settings.end()) continue;
    if (message.starts_with(option)) {
      message.replace(0, option.size(), key);
    } else if (key != "schemes" || !message.starts_with("scheme ")) {
      continue;
    }
    reject_at(study.file, setting->second.position, message);
  }
  reject_at(study.file, family.position, message);
}

bool have_same_settings(const StudyFamily& a, const StudyFamily& b) {
  return std::ranges::equal(a.settings, b.settings, [](const auto& one, const auto& other) {
    return one.first == other.first && one.second.texts == other.second.texts;
  });
}

}  // namespace

std::vector<Sweep> sweeps_of(const Study& study) {
  std::vector<Sweep> sweeps;
  std::vector<const StudyFamily*> firsts;  // of each sweep
  for (const auto& family : study.families) {
    const auto same =
        std::ranges::find_if(firsts, [&](const auto* first) { return have_same_settings(*first, family); });
    if (same != firsts.end()) {
      auto& scenes = sweeps[static_cast<std::size_t>(same - firsts.begin())].scenes;
      scenes.insert(scenes.end(), family.scenes.begin(), family.scenes.end());
      continue;
    }
    try {
      sweeps.push_back(sweep_of(given_of(family.settings), family.scenes));
    } catch (const std::invalid_argument& wrong) {
      reject_setting(study, family, wrong.what());
    }
    sweeps.back().describes_solutions = false;
    firsts.push_back(&family);
  }
  return sweeps;
}

std::string budget_of_sweeps_text() {
  return fmt::format("{} with --steps or --accuracy, {} with --thorough, otherwise {}", usual_budget,
                     thorough_budget, budget_of_search);
}

std::vector<Sweep> sweeps_of(const Given& given, const SceneRegistry& known) {
  const auto study = given.find("--study"), shard = given.find("--shard");
  auto sweeps = study ? sweeps_of(read_study(*study, known)) : listed_sweeps(given, known);
  for (auto& sweep : sweeps) set_timing(given.has("--examine"), given.has("--undisturbed"), sweep);
  return shard ? shard_of(std::move(sweeps), parse_shard(*shard)) : sweeps;
}

bool count_is_exact(const std::vector<Sweep>& sweeps) {
  return std::ranges::none_of(sweeps, [](const auto& sweep) { return sweep.plan.goal.has_value(); });
}

}  // namespace fde::bench
