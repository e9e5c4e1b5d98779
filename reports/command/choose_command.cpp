// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <ostream>
#include <set>
#include <sstream>
#include <utility>

#include "fdebench/benchmarks/observers/comparison_steps.hpp"
#include "fdebench/benchmarks/references/reference_of.hpp"
#include "fdebench/benchmarks/search/estimated_reference.hpp"
#include "fdebench/benchmarks/text/number_text.hpp"
#include "fdebench/benchmarks/text/printable.hpp"
#include "fdebench/reports/analysis/compared_columns.hpp"
#include "fdebench/reports/analysis/recommendation.hpp"
#include "fdebench/reports/analysis/text.hpp"
#include "fdebench/reports/command/command.hpp"
#include "fdebench/reports/command/help_text.hpp"
#include "fdebench/reports/command/progress_display.hpp"
#include "fdebench/reports/command/recorded_scene.hpp"

namespace fde::bench {
namespace {

std::vector<std::string> settings_of(const Given& given) {
  auto settings = given.all("--set");
  if (const auto until = given.find("--until")) settings.push_back("until=" + *until);
  return settings;
}

// The columns named in `requested`, or all.
std::vector<Eigen::Index> chosen_columns(const Scene& scene, const std::optional<std::string>& requested) {
  if (!requested) return all_columns(scene);
  const auto& names = scene.outputs.names;
  std::vector<Eigen::Index> columns;
  for (const auto& name : split_names(*requested)) {
    const auto found = std::ranges::find(names, name);
    if (found == names.end()) reject_text("--columns", name, fmt::format("of {}", fmt::join(names, ", ")));
    columns.push_back(found - names.begin());
  }
  return columns;
}

// From the reference, at times that are independent of any grid.
std::vector<SmallColumn> small_columns(const Scene& scene, const AccuracyTarget& question) {
  constexpr int evenly = 128;
  std::vector<std::string> names;
  std::vector<double> largest(question.columns.size(), 0.0);
  for (const auto column : question.columns)
    names.push_back(scene.outputs.names[static_cast<std::size_t>(column)]);
  for (const double t : comparison_times(scene.problem, evenly)) {
    const Vec values = scene.reference.at(t).value;
    for (std::size_t i = 0; i < largest.size(); ++i)
      largest[i] = std::max(largest[i], std::abs(values[question.columns[i]]));
  }
  return small_columns(question.kind, question.accuracy, names, largest);
}

// Without a reference, an error estimate may take up to a third of the time.
Recommendation searched(const SceneVariant& variant, Scene scene, const AccuracyTarget& question,
                        double seconds, const Streams& streams) {
  constexpr double part_of_estimate = 1.0 / 3.0;
  ProgressLine line(streams, "", true);
  const SearchProgress tell = [&](const std::string& what, double part) {
    line.set({.part = std::min(part, 1.0), .current_run = what});
  };
  const auto start = std::chrono::steady_clock::now();
  const bool at_points_only = is_examined_at_points_only(scene);
  auto known = reference_or_estimate(scene, question, part_of_estimate * seconds, tell);
  scene.reference = std::move(known.reference);
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
  const auto found = search(scene, question, std::max(0.0, seconds - taken.count()), tell);
  auto made = recommend(found, variant.key(), scene.outputs.names, question, known.estimate);
  made.small = small_columns(scene, question);
  made.examined_at_points_only = at_points_only;
  return made;
}

// The errors of the recorded runs over the columns of --columns.
void compare_over_requested(Runs& runs, const SceneSettings& scene, const Given& given) {
  const auto requested = split_names(given.text("--columns"));
  std::set<std::string> known;
  for (const Record& run : of_scene(runs.finished, scene)) {
    if (!run.columns.values.empty()) known.insert(run.columns.names.begin(), run.columns.names.end());
  }
  for (const auto& name : requested) {
    if (known.contains(name)) continue;
    reject_text("--columns", name,
                known.empty()
                    ? fmt::format("without --results, or with errors of single columns, which {} does not "
                                  "have: fdebench run measures them anew",
                                  given.text("--results"))
                    : fmt::format("of {}", fmt::join(known, ", ")));
  }
  compare_over(runs, scene, requested);
}

// A recommendation from recorded runs, which need no search time.
Recommendation recorded(const ErrorKind& kind, double accuracy, bool first_run, const Given& given,
                        const Streams& streams, const SceneRegistry& known) {
  if (given.has("--max-time")) given.refuse("--max-time", "without --results");
  const auto results = given.text("--results");
  auto [sessions, runs, warning] = read_runs(results);
  warn(streams, warning);
  if (first_run) count_first_runs(runs);
  const auto requested = recorded_scene(runs, results, given.text("scene"), settings_of(given), known);
  if (given.has("--columns")) compare_over_requested(runs, requested, given);
  warn(streams, not_compared_text(runs, requested));
  return recommend(runs, requested, kind, accuracy);
}

// The answer with what its first three lines begin with in bold, and the command in green.
std::string with_bold_labels(const std::string& answer, bool coloured) {
  if (!coloured) return answer;
  constexpr int lines_of_answer = 3;
  std::istringstream lines(answer);
  std::string text, line;
  for (int i = 0; std::getline(lines, line); ++i) {
    const auto label = i < lines_of_answer ? line.find(':') : std::string::npos;
    if (label != std::string::npos) {
      const auto rest = line.substr(label + 1);
      line = in_colour(line.substr(0, label + 1), Colour::bold, true) +
             (i == 0 ? in_colour(rest, Colour::green, true) : rest);
    }
    text += line + '\n';
  }
  return text;
}

void choose(const Given& given, const Streams& streams, const SceneRegistry& known) {
  const double accuracy = given.number("--error");
  const ErrorKind kind{parse_norm(given.text("--norm")), parse_scale(given.text("--scale"))};
  const double seconds = given.number("--max-time");
  const bool first_run = requests_first_run(given);
  Recommendation made;
  if (given.has("--results")) {
    made = recorded(kind, accuracy, first_run, given, streams, known);
  } else {
    const auto columns = given.find("--columns");
    const auto variant = parse_variant(given.text("scene"), settings_of(given), known);
    const Scene scene = make_scene(variant);
    const AccuracyTarget question{kind, accuracy, chosen_columns(scene, columns), first_run};
    made = searched(variant, scene, question, seconds, streams);
    if (columns) made.columns = split_names(*columns);
  }
  if (made.options.empty()) {
    if (made.estimate) made.missing.push_back(estimate_text(*made.estimate));
    const auto columns = made.columns.empty() ? "" : fmt::format(", in {}", fmt::join(made.columns, ", "));
    throw NumericalFailure(fmt::format("no run of {} is within {} ({}{}): {}", label_of(made.scene),
                                       error_text(accuracy), kind_text(kind), columns,
                                       fmt::join(made.missing, "; ")));
  }
  streams.out << (given.has("--json") ? json_of(made)
                                      : with_bold_labels(to_text(made, given.has("--verbose")),
                                                         streams.out_columns > 0 && streams.colours));
}

}  // namespace

Command choose_command() {
  return {
      {"choose",
       "Solve and choose",
       "Recommend scheme, grid and steps for a scene and an accuracy",
       {scene_argument(),
        set_argument(),
        {"--error E", "largest error wanted",
         Range{.low = 1e-15, .high = 1.0, .open_low = true, .open_high = true}},
        {"[--norm NORM]", "where the error is measured: at the end, or at all steps",
         Words{std::string(name(Norm::end)), std::string(name(Norm::maximum))}, "maximum"},
        {"[--scale SCALE]", "what an error is divided by: 1, |y|, 1 + |y| or the largest |y| of its column",
         scale_names(), "mixed"},
        {"[--columns A,B,...]", "columns that count", {}, "all"},
        runs_argument(),
        until_argument(),
        {"[--max-time SECONDS]", "time for the search", Range{.low = 0.0, .high = 1e6, .open_low = true},
         "60"},
        {"[--results FILE]", "take the runs of a results file; nothing is measured", Completion::results},
        {"[--verbose]", "print all grids, why the first is the quickest, and the schemes that refuse"},
        {"[--json]", "print one JSON object"}},
       {{"fdebench choose pendulum --error 1e-6", "recommends a scheme for the pendulum up to t = 20."},
        {"fdebench choose mine.toml --error 1e-4 --norm end --scale relative --max-time 10",
         "does so for an equation file, by the relative error at the end, in ten seconds."}},
       {"solve", "run", "choosing", "accuracy"}},
      choose};
}

}  // namespace fde::bench
