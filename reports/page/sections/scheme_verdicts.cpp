// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "fdebench/benchmarks/records/default_accuracies.hpp"
#include "fdebench/reports/analysis/trial_result.hpp"
#include "fdebench/reports/page/facts.hpp"

namespace fde::bench {
namespace {

using nlohmann::json;

// The results of a line in the map of answers.
struct LineScore {
  int won = 0;                    // number of cells in which it is the cheapest
  double nearest = INFINITY;      // smallest ratio of its time to the winner's
  std::string nearest_on{};       // scene of `nearest`
  double nearest_accuracy = 0.0;  // accuracy of `nearest`
};

// By label of the line; without lines that are within no accuracy.
std::map<std::string, LineScore> scores_of(const PageInput& page, const ErrorKind& kind) {
  std::map<std::string, LineScore> found;
  for (const RunSpan runs : by_scene(page.runs.finished)) {
    const auto& scene = runs.front().key.scene;
    const SceneLines lines(page.runs, scene);
    for (const double accuracy : default_accuracies) {
      const auto ranked = lines.within(kind, accuracy);
      if (!ranked.empty()) ++found[page.label(ranked.front())].won;
      for (const RecommendedRun& option : ranked) {
        auto& of = found[page.label(option)];
        const double ratio = option.time.median / ranked.front().time.median;
        if (ratio >= of.nearest) continue;
        of.nearest = ratio;
        of.nearest_on = label_of(scene);
        of.nearest_accuracy = accuracy;
      }
    }
  }
  return found;
}

// The names with the largest counts first.
json by_count(const std::map<std::string, int>& counts) {
  std::vector<std::pair<std::string, int>> all(counts.begin(), counts.end());
  std::ranges::stable_sort(all, std::greater{}, &std::pair<std::string, int>::second);
  json names = json::array();
  for (const auto& [name, count] : all) names.push_back(name);
  return names;
}

// The runs of a line with one bad verdict, counted by scene and by reason.
struct Counted {
  std::map<std::string, int> scenes{}, reasons{};
};

// The reason without its detail for one scene, as in "takes no algebraic rows: component 6 is one".
std::string general(const std::string& reason) { return reason.substr(0, reason.find(": component")); }

// What speaks against a line: the scenes by verdict, with the most frequent reason of refusals. A line that
// has finished a scene in other runs does not refuse it, although it may refuse steps longer than a delay.
json against(const PageInput& page, const std::string& line) {
  std::vector<std::string> solved;
  for (const Record& run : page.runs.finished)
    if (page.label(run.key) == line) solved.push_back(label_of(run.key.scene));
  std::map<std::string_view, Counted> counted;
  const auto count = [&](const Record& run) {
    if (page.label(run.key) != line) return;
    const TrialResult result = trial_result(run);
    if (result == refuses && std::ranges::find(solved, label_of(run.key.scene)) != solved.end()) return;
    auto& of = counted[result.word];
    ++of.scenes[run.key.scene.id];
    ++of.reasons[general(run.ending.detail)];
  };
  std::ranges::for_each(page.trials, count);
  for (const Record& run : page.runs.failed) {
    if (std::ranges::none_of(page.trials, [&](const Record& trial) { return trial.key == run.key; }))
      count(run);
  }
  json all = json::array();
  for (const TrialResult& of : {fails, inaccurate, refuses}) {
    const auto& [scenes, reasons] = counted[of.word];
    if (scenes.empty()) continue;
    json facts{{std::string(of.word), by_count(scenes)}};
    if (of == refuses) {
      facts["reason"] =
          std::ranges::max_element(reasons, {}, &std::pair<const std::string, int>::second)->first;
    }
    all.push_back(std::move(facts));
  }
  return all;
}

}  // namespace

std::map<std::string, int> cells_won(const PageInput& page, const ErrorKind& kind) {
  std::map<std::string, int> won;
  for (const auto& [line, score] : scores_of(page, kind)) won[line] = score.won;
  return won;
}

json scheme_verdicts(const PageInput& page) {
  json all = json::array();
  for (const auto& line : page.labels({page.runs.finished, page.runs.failed, page.trials})) {
    const auto trials =
        std::ranges::count_if(page.trials, [&](const auto& run) { return page.label(run.key) == line; });
    all.push_back(
        {{"line", line}, {"against", against(page, line)}, {"trials", trials > 0 ? json(trials) : json()}});
  }
  for (const ErrorKind& kind : error_kinds) {
    const auto scores = scores_of(page, kind);
    for (json& of : all) {
      const auto found = scores.find(of["line"]);
      if (found == scores.end()) continue;
      const auto& [won, nearest, scene, accuracy] = found->second;
      of["nearest"][std::string(error_measure(kind))] = {
          {"scene", scene}, {"accuracy", accuracy}, {"ratio", fact(nearest)}};
    }
  }
  return all;
}

}  // namespace fde::bench
