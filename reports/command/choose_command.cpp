// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <ostream>
#include <set>
#include <utility>

#include "fdebench/benchmarks/requests/answers_json.hpp"
#include "fdebench/benchmarks/requests/choice.hpp"
#include "fdebench/benchmarks/text/number_text.hpp"
#include "fdebench/benchmarks/text/printable.hpp"
#include "fdebench/reports/analysis/compared_columns.hpp"
#include "fdebench/reports/analysis/recorded_recommendation.hpp"
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

// The answer of a search, shown while it lasts.
Recommendation searched(const Given& given, const ChoiceRequest& request, const Streams& streams,
                        const SceneRegistry& known) {
  const auto variant = read_variant(given.text("scene"), settings_of(given), known);
  Scene scene = make_scene(variant);
  ProgressLine line(streams, "", true);
  const SearchProgress tell = [&](const std::string& what, double part) {
    line.set({.part = std::min(part, 1.0), .current_run = what});
  };
  try {
    return choose(std::move(scene), request, variant.key(), tell);
  } catch (const Refusal& refusal) {
    given.refuse(refusal, {{"seconds", "--max-time"}});
  }
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
Recommendation recorded(const ChoiceRequest& request, const Given& given, const Streams& streams,
                        const SceneRegistry& known) {
  if (given.has("--max-time")) given.refuse("--max-time", "without --results");
  const auto results = given.text("--results");
  auto [sessions, runs, warning] = read_runs(results);
  warn(streams, warning);
  if (request.first_run) count_first_runs(runs);
  const auto scene = recorded_scene(runs, results, given.text("scene"), settings_of(given), known);
  if (given.has("--columns")) compare_over_requested(runs, scene, given);
  warn(streams, not_compared_text(runs, scene));
  auto made = recommend(runs, scene, request.kind, request.error);
  require_option(made);
  return made;
}

// Labels in bold and the command in green, on a terminal with colours.
Emphasis emphasis_on(const Streams& streams) {
  const bool shown = streams.out_columns > 0 && streams.colours;
  return {.label = [=](const std::string& text) { return in_colour(text, Colour::bold, shown); },
          .command = [=](const std::string& text) { return in_colour(text, Colour::green, shown); }};
}

void print_choice(const Given& given, const Streams& streams, const SceneRegistry& known) {
  const ChoiceRequest request{
      .error = given.number("--error"),
      .kind = {parse_norm(given.word("--norm")), parse_scale(given.word("--scale"))},
      .columns = given.has("--columns") ? split_names(given.text("--columns")) : std::vector<std::string>(),
      .seconds = given.number("--max-time"),
      .first_run = requests_first_run(given)};
  const auto made = given.has("--results") ? recorded(request, given, streams, known)
                                           : searched(given, request, streams, known);
  streams.out << (given.has("--json") ? json_of(made).dump() + '\n'
                                      : to_text(made, given.has("--verbose"), emphasis_on(streams)));
}

}  // namespace

Command choose_command() {
  return {
      {"choose",
       "Solve and choose",
       "Recommend scheme, grid and steps for a scene and an accuracy",
       {scene_argument(),
        set_argument(),
        {"--error E", "largest error wanted", searched_errors},
        {"[--norm NORM]", "where the error is measured: at the end, or at all steps",
         Words{std::string(name(Norm::end)), std::string(name(Norm::maximum))}, "maximum"},
        {"[--scale SCALE]", "what an error is divided by: 1, |y|, 1 + |y| or the largest |y| of its column",
         scale_names(), "mixed"},
        {"[--columns A,B,...]", "columns that count", {}, "all"},
        runs_argument(),
        until_argument(),
        {"[--max-time SECONDS]", "time for the search", searched_seconds,
         fmt::format("{}", ChoiceRequest().seconds)},
        {"[--results FILE]", "take the runs of a results file; nothing is measured", Completion::results},
        {"[--verbose]", "print all grids, why the first is the quickest, and the schemes that refuse"},
        {"[--json]", "print one JSON object"}},
       {{"fdebench choose pendulum --error 1e-6", "recommends a scheme for the pendulum up to t = 20."},
        {"fdebench choose mine.toml --error 1e-4 --norm end --scale relative --max-time 10",
         "does so for an equation file, by the relative error at the end, in ten seconds."}},
       {"solve", "run", "choosing", "accuracy"}},
      print_choice};
}

}  // namespace fde::bench
