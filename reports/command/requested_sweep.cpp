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

namespace fde::bench {
namespace {

constexpr TimingRepeats of_default_sweep{.min_seconds = 0.002, .enough_seconds = 0.03};

// Budgets of a run in seconds: with --steps or --accuracy; in a thorough sweep; otherwise. Schemes with
// adaptive step size may need very many steps on unsuitable problems.
constexpr auto usual_budget = "600";
constexpr double thorough_budget = 60.0, budget_of_search = 1.0;

std::vector<SceneVariant> chosen_scenes(const std::vector<std::string>& texts,
                                        const std::vector<std::string>& settings,
                                        const SceneRegistry& known) {
  if (texts.empty() && !settings.empty()) reject_text("--set", settings.front(), "with --scene");
  if (texts.empty()) return sweep_scenes();
  std::vector<SceneVariant> variants;
  for (const auto& text : texts)
    std::ranges::copy(parse_variants(text, settings, known), std::back_inserter(variants));
  return variants;
}

// The named schemes. If none is named: all, or none if external programs are given.
std::vector<const Scheme*> chosen_schemes(const SweepArguments& arguments) {
  const auto& ids = arguments.schemes;
  if (ids.empty()) return arguments.externals.empty() ? sweep_schemes() : std::vector<const Scheme*>{};
  std::vector<const Scheme*> entries;
  for (const auto& id : ids) entries.push_back(&scheme_named(id));
  return entries;
}

std::vector<ExternalProgram> chosen_programs(const SweepArguments& arguments) {
  std::vector<ExternalProgram> programs;
  for (const auto& text : arguments.externals) {
    programs.push_back(parse_external(text));
    const auto& name = programs.back().name;
    if (std::ranges::count(programs, name, &ExternalProgram::name) > 1)
      reject_text("--external", text, "a name that no other program has");
  }
  if (!programs.empty() && arguments.accuracies)
    reject_text("--accuracy", *arguments.accuracies, "without --external, whose programs take --steps");
  return programs;
}

// The requested numbers of steps and tolerances; by default default_plan() or thorough_plan().
SweepPlan chosen_plan(const SweepArguments& arguments) {
  if (!arguments.steps && !arguments.accuracies) return arguments.thorough ? thorough_plan() : default_plan();
  SweepPlan chosen;
  for (const auto& text : arguments.steps ? split_list(*arguments.steps) : std::vector<std::string>{})
    chosen.resolutions.emplace_back(parse_count("--steps", text, step_counts));
  for (const auto& text :
       arguments.accuracies ? split_list(*arguments.accuracies) : std::vector<std::string>{})
    chosen.resolutions.emplace_back(parse_accuracy(text));
  return chosen;
}

Sweep sweep_of(const SweepArguments& arguments, std::vector<SceneVariant> scenes) {
  Sweep sweep{.scenes = std::move(scenes),
              .schemes = chosen_schemes(arguments),
              .programs = chosen_programs(arguments),
              .plan = chosen_plan(arguments),
              .setup = parse_run_settings(arguments.means),
              .optimal_grids = requests_optimal_grading(arguments.means)};
  if (arguments.accuracies && !arguments.steps && arguments.means.grid != RunSettingsArguments{}.grid) {
    reject_text("--grid", arguments.means.grid,
                "with --steps: schemes that take --accuracy choose their times");
  }
  if (sweep.optimal_grids && !sweep.programs.empty())
    reject_text("--grid", arguments.means.grid, "uniform or graded:R beside --external");
  if (sweep.plan.goal) sweep.repeats = of_default_sweep;
  const bool listed = arguments.steps || arguments.accuracies;
  if (!listed && arguments.means.budget == usual_budget)
    sweep.setup.budget = sweep.plan.goal ? budget_of_search : thorough_budget;
  sweep.repeats.most = parse_count("--repeat", arguments.repeats, repeat_counts);
  return sweep;
}

// The sweeps of the options, without those of a study.
std::vector<Sweep> listed_sweeps(const SweepArguments& arguments, const SceneRegistry& known) {
  const bool listed = arguments.steps || arguments.accuracies;
  if (arguments.trials && (listed || !arguments.scenes.empty()))
    throw std::invalid_argument("--trials = yes: must be without --scene and --steps, trials have their own");
  if (arguments.thorough && listed)
    throw std::invalid_argument("--thorough = yes: must be without --steps and --accuracy, it has its own");
  Sweep sweep = sweep_of(arguments, chosen_scenes(arguments.scenes, arguments.settings, known));
  std::vector<Sweep> sweeps;
  if (arguments.trials || (!listed && arguments.scenes.empty()))
    sweeps = sweeps_of_trials(sweep, arguments.thorough);
  const bool whole = !listed && arguments.scenes.empty() && arguments.schemes.empty();
  if (whole && arguments.means.grid == RunSettingsArguments{}.grid) sweep.graded = graded_schemes();
  if (!arguments.trials) sweeps.push_back(std::move(sweep));
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
SweepArguments arguments_of(const StudySettings& settings) {
  SweepArguments arguments;
  const auto set = [&](std::string_view key, auto& into) {
    const auto found = settings.find(std::string(key));
    if (found == settings.end()) return;
    if constexpr (requires {
                    into.push_back(std::string());
                    into.front().front();
                  }) {
      into = found->second.texts;
    } else {
      into = fmt::format("{}", fmt::join(found->second.texts, ","));
    }
  };
  set("schemes", arguments.schemes);
  set("external", arguments.externals);
  set("steps", arguments.steps);
  set("accuracies", arguments.accuracies);
  set("grid", arguments.means.grid);
  set("history", arguments.means.history);
  set("tolerance", arguments.means.tolerance);
  set("budget", arguments.means.budget);
  set("repeat", arguments.repeats);
  return arguments;
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
      sweeps.push_back(sweep_of(arguments_of(family.settings), family.scenes));
    } catch (const std::invalid_argument& wrong) {
      reject_setting(study, family, wrong.what());
    }
    sweeps.back().describes_solutions = false;
    firsts.push_back(&family);
  }
  return sweeps;
}

RunSettingsArguments SweepArguments::usual_settings() {
  return {.budget = usual_budget,
          .budget_text = fmt::format("{} with --steps or --accuracy, {} with --thorough, otherwise {}",
                                     usual_budget, thorough_budget, budget_of_search)};
}

std::vector<Sweep> sweeps_of(const SweepArguments& arguments, const SceneRegistry& known) {
  auto sweeps =
      arguments.study ? sweeps_of(read_study(*arguments.study, known)) : listed_sweeps(arguments, known);
  for (auto& sweep : sweeps) set_timing(arguments.examine, arguments.undisturbed, sweep);
  return arguments.shard ? shard_of(std::move(sweeps), parse_shard(*arguments.shard)) : sweeps;
}

bool count_is_exact(const std::vector<Sweep>& sweeps) {
  return std::ranges::none_of(sweeps, [](const auto& sweep) { return sweep.plan.goal.has_value(); });
}

}  // namespace fde::bench
