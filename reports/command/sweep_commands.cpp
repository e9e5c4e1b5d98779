// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <functional>
#include <optional>
#include <ostream>
#include <stdexcept>
#include <utility>

#include "fdebench/benchmarks/records/results_file.hpp"
#include "fdebench/benchmarks/sweep/default_sweep.hpp"
#include "fdebench/benchmarks/sweep/forecast.hpp"
#include "fdebench/benchmarks/sweep/shard.hpp"
#include "fdebench/benchmarks/sweep/sweep.hpp"
#include "fdebench/benchmarks/sweep/trials.hpp"
#include "fdebench/benchmarks/text/number_text.hpp"
#include "fdebench/reports/analysis/runs.hpp"
#include "fdebench/reports/analysis/text.hpp"
#include "fdebench/reports/command/arguments.hpp"
#include "fdebench/reports/command/command.hpp"
#include "fdebench/reports/command/progress_display.hpp"
#include "fdebench/reports/command/signal_cleanup.hpp"
#include "fdebench/reports/page/report.hpp"

namespace fde::bench {
namespace {

constexpr CountRange repeat_counts{1, 1000};
constexpr TimingRepeats of_default_sweep{.min_seconds = 0.003, .enough_seconds = 0.1};

// Budgets of a run: in seconds with --steps or --accuracy; in seconds in a thorough sweep; otherwise as a
// multiple of the goal's most_seconds. Schemes with adaptive step size may need very many steps on unsuitable
// problems.
constexpr auto usual_budget = "600";
constexpr double thorough_budget = 60.0, far_from_an_answer = 5.0;

struct SweepArguments {
  std::vector<std::string> scenes, settings, schemes, externals;
  std::optional<std::string> steps, accuracies;
  RunSettingsArguments means{
      .budget = usual_budget,
      .budget_text =
          fmt::format("{} with --steps or --accuracy, {} with --thorough, otherwise {}", usual_budget,
                      thorough_budget, far_from_an_answer* default_plan().goal->most_seconds)};
  std::string repeats = "3";
  std::optional<std::string> out;
  std::optional<std::string> shard;
  bool trials = false, thorough = false, dry_run = false, examine = false, undisturbed = false;
};

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

// Timings that are left out, or repeated where they are disturbed, need runs that do not depend on times.
void set_timing(bool examine, bool undisturbed, Sweep& sweep) {
  constexpr int attempts = 3;
  constexpr auto allowed =
      "with --steps, --accuracy or --thorough: otherwise times decide which runs are made";
  if (examine && sweep.plan.goal) reject_text("--examine", "yes", allowed);
  if (undisturbed && sweep.plan.goal) reject_text("--undisturbed", "yes", allowed);
  if (examine && undisturbed) reject_text("--undisturbed", "yes", "without --examine, which times nothing");
  sweep.examines_only = examine;
  sweep.retimes = undisturbed;
  if (undisturbed) sweep.repeats.attempts = attempts;
}

Sweep sweep_of(const SweepArguments& arguments, const SceneRegistry& known) {
  Sweep sweep{.scenes = chosen_scenes(arguments.scenes, arguments.settings, known),
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
  if (!listed && arguments.means.budget == usual_budget) {
    sweep.setup.budget =
        sweep.plan.goal ? far_from_an_answer * sweep.plan.goal->most_seconds : thorough_budget;
  }
  sweep.repeats.most = parse_count("--repeat", arguments.repeats, repeat_counts);
  set_timing(arguments.examine, arguments.undisturbed, sweep);
  return sweep;
}

// The requested sweep. With --trials the trials only; without scenes and steps the trials as well.
std::vector<Sweep> sweeps_of(const SweepArguments& arguments, const SceneRegistry& known) {
  const bool listed = arguments.steps || arguments.accuracies;
  if (arguments.trials && (listed || !arguments.scenes.empty()))
    throw std::invalid_argument("--trials = yes: must be without --scene and --steps, trials have their own");
  if (arguments.thorough && listed)
    throw std::invalid_argument("--thorough = yes: must be without --steps and --accuracy, it has its own");
  Sweep sweep = sweep_of(arguments, known);
  std::vector<Sweep> sweeps;
  if (arguments.trials || (!listed && arguments.scenes.empty()))
    sweeps = sweeps_of_trials(sweep, arguments.thorough);
  const bool whole = !listed && arguments.scenes.empty() && arguments.schemes.empty();
  if (whole && arguments.means.grid == RunSettingsArguments{}.grid) sweep.graded = graded_schemes();
  if (!arguments.trials) sweeps.push_back(sweep);
  return arguments.shard ? shard_of(std::move(sweeps), parse_shard(*arguments.shard)) : sweeps;
}

// Whether the forecast number of runs is exact: with a goal the refinement may end elsewhere than forecast.
bool count_is_exact(const std::vector<Sweep>& sweeps) {
  return std::ranges::none_of(sweeps, [](const auto& sweep) { return sweep.plan.goal.has_value(); });
}

Forecast forecast_of(const std::vector<Sweep>& sweeps,
                     const std::function<RecordedRun(const RunKey&)>& recorded) {
  Forecast expected;
  for (const auto& sweep : sweeps) expected.merge(forecast(sweep, recorded));
  return expected;
}

void run_and_show(const std::vector<Sweep>& sweeps, const Streams& streams, ResultsFile& file) {
  const auto recorded = [&](const RunKey& key) { return file.recorded(key); };
  const Forecast expected = forecast_of(sweeps, recorded);
  SweepProgress progress(streams, expected, count_is_exact(sweeps));
  const SweepCallbacks hooks{.recorded = recorded,
                             .append = [&](const auto& rows) { file.append(rows); },
                             .on_event = [&](const SweepEvent& event) { progress.on_event(event); },
                             .describes = [&](const SceneSettings& scene) { return file.describes(scene); },
                             .append_scene = [&](const SceneDescription& scene) { file.append(scene); }};
  for (const auto& sweep : sweeps) run_sweep(sweep, hooks, expected);
}

// Prints the remaining runs with their expected seconds, and the total.
void list_runs(const std::vector<Sweep>& sweeps, const SweepArguments& arguments, const Streams& streams) {
  const auto recorded = arguments.out ? read_recorded(*arguments.out) : RecordedByKey();
  const auto expected = forecast_of(sweeps, [&](const RunKey& key) { return recorded_of(recorded, key); });
  for (const auto& [run, seconds] : expected) {
    streams.out << fmt::format("{} {} {}  {}\n", label_of(run.scene), run.scheme, resolution_text(run.setup),
                               time_text(seconds));
  }
  streams.out << fmt::format("{}{} runs, about {}\n", count_is_exact(sweeps) ? "" : "about ", expected.size(),
                             duration_text(total_seconds(expected)));
}

void run(const SweepArguments& arguments, const Streams& streams, const SceneRegistry& known) {
  const auto sweeps = sweeps_of(arguments, known);
  if (arguments.dry_run) return list_runs(sweeps, arguments, streams);
  if (!arguments.out) throw std::invalid_argument("--out is required");
  ResultsFile file(*arguments.out);
  const SignalCleanup words(
      streams.quiet
          ? ""
          : fmt::format("{}fdebench: stopped; the same command continues, what is measured is kept\n",
                        streams.columns > 0 ? "\n" : ""));
  run_and_show(sweeps, streams, file);
  streams.out << std::filesystem::absolute(*arguments.out).string() << '\n';
}

}  // namespace

void add_sweep_commands(CommandLine& program, const Streams& streams, const SceneRegistry& known) {
  auto of_run = std::make_shared<SweepArguments>();
  Subcommand run_command(program, "run", "Measure schemes on scenes; a file that exists is continued");
  run_command.group("Measure");
  run_command.list("--scene", of_run->scenes, "id of a scene or an equation file, or ID:NAME=VALUE,...")
      .takes("SCENE")
      .usual("all")
      .completed_by(Completion::scene);
  run_command.list("--set", of_run->settings, "a parameter of all these scenes, a value or FIRST:LAST:STEP")
      .takes("NAME=VALUE")
      .completed_by(Completion::setting);
  run_command.list("--scheme", of_run->schemes, "id of a scheme")
      .takes("ID")
      .usual("all")
      .completed_by(Completion::scheme);
  run_command
      .list("--external", of_run->externals,
            "another program to measure; then of the schemes here only those of --scheme")
      .takes("NAME=COMMAND");
  run_command
      .option("--steps", of_run->steps, "numbers of steps; without them the cheapest runs are searched")
      .takes("N1,N2,...", step_counts);
  run_command.option("--accuracy", of_run->accuracies, "tolerances of schemes that choose their steps")
      .takes("E1,E2,...", positive);
  run_command.option("--repeat", of_run->repeats, "how often each run is timed")
      .takes("R", repeat_counts)
      .usual(of_run->repeats);
  add_options(run_command, of_run->means);
  run_command.flag("--thorough", of_run->thorough, "all numbers of steps, all tolerances and all trials");
  run_command.flag("--trials", of_run->trials, "only the stiff and extreme trials of the report");
  run_command.option("--shard", of_run->shard, "every N-th scene, from the I-th on").takes("I/N");
  run_command.flag("--examine", of_run->examine,
                   "everything but the times, which the same command without it adds");
  run_command.flag("--undisturbed", of_run->undisturbed,
                   "repeat the times that other work disturbed, also those of the file");
  run_command.flag("--dry-run", of_run->dry_run, "list the runs and how long they take, and do nothing");
  run_command.option("--out", of_run->out, "results file; needed without --dry-run")
      .takes("FILE")
      .completed_by(Completion::results);
  run_command.example("fdebench run --out results.jsonl",
                      "measures all schemes on all scenes; this takes minutes.");
  run_command.example(
      "fdebench run --scene pendulum --scheme l1 --scheme bdf4 --steps 64,256,1024 --out few.jsonl",
      "measures six runs.");
  run_command.see_also({"report", "choose", "plot", "judge", "accuracy"});
  run_command.callback([=, &streams, &known] { run(*of_run, streams, known); });

  auto file = std::make_shared<std::string>(), folder = std::make_shared<std::string>();
  auto second = std::make_shared<std::optional<std::string>>();
  Subcommand report_command(program, "report",
                            "Write the report page of a results file, or of what changed in a second");
  report_command.group("Measure");
  report_command.required("file", *file, "results file").completed_by(Completion::results);
  report_command.option("second", *second, "results file, now: the page is of it, set against the first")
      .completed_by(Completion::results);
  report_command.required("--out", *folder, "folder of the page")
      .takes("DIR")
      .completed_by(Completion::folder);
  auto runs = std::make_shared<std::string>(run_words().back());
  add_runs(report_command, *runs);
  report_command.example("fdebench report results.jsonl --out page", "writes page/index.html.");
  report_command.example("fdebench report old.jsonl new.jsonl --out page",
                         "writes the page of the second file with what changed since the first.");
  report_command.see_also({"run", "compare", "plot"});
  report_command.callback([=, &streams] {
    const bool first_runs = requests_first_run(*runs);
    const auto read = [&](const std::string& from) {
      auto of_file = read_runs(from);
      if (first_runs) count_first_runs(of_file.runs);
      return of_file;
    };
    auto first = read(*file);
    const auto path = [&] {
      ProgressLine line(streams, "writes the page");
      return *second ? write_report(read(**second), *folder, std::move(first))
                     : write_report(std::move(first), *folder);
    }();
    streams.out << path.string() << '\n';
  });
}

}  // namespace fde::bench
