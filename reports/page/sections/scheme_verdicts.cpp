// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "fdebench/reports/analysis/text.hpp"
#include "fdebench/reports/analysis/trial_result.hpp"
#include "fdebench/reports/page/accuracies.hpp"
#include "fdebench/reports/page/page_data.hpp"
#include "fdebench/schemes/stepping/scheme.hpp"

namespace fde::bench {
namespace {

constexpr std::size_t most_named = 3;  // scenes in a sentence

// The results of a line in the map of answers.
struct LineScore {
  std::vector<double> margins{};        // time of the second line / own time, in each cell that it wins
  std::map<std::string, int> won_on{};  // number of cells won, by scene
  double nearest = INFINITY;            // smallest ratio of its time to the winner's
  std::string nearest_on{};             // scene of `nearest`
  double nearest_accuracy = 0.0;        // accuracy of `nearest`
  int reached = 0;                      // number of cells in which it is within the accuracy

  [[nodiscard]] int won() const {
    int cells = 0;
    for (const auto& [scene, of_scene] : won_on) cells += of_scene;
    return cells;
  }
};

struct LineScores {
  std::map<std::string, LineScore> of{};  // by label of the line
  int cells = 0;                          // number of cells with a winner
};

LineScores standings_of(const PageInput& page, const ErrorKind& kind) {
  LineScores found;
  for (const RunSpan runs : by_scene(page.runs.finished)) {
    const auto& scene = runs.front().key.scene;
    const SceneLines lines(page.runs, scene);
    for (const double accuracy : accuracies) {
      const auto ranked = lines.within(kind, accuracy);
      if (ranked.empty()) continue;
      ++found.cells;
      auto& winner = found.of[page.label(ranked.front())];
      ++winner.won_on[scene.id];
      if (ranked.size() > 1) winner.margins.push_back(ranked[1].time.median / ranked.front().time.median);
      for (const RecommendedRun& option : ranked) {
        auto& of = found.of[page.label(option)];
        const double ratio = option.time.median / ranked.front().time.median;
        ++of.reached;
        if (ratio >= of.nearest) continue;
        of.nearest = ratio;
        of.nearest_on = label_of(scene);
        of.nearest_accuracy = accuracy;
      }
    }
  }
  return found;
}

// The names with the largest counts, and the number of further names.
std::string named(const std::map<std::string, int>& counts) {
  std::vector<std::pair<std::string, int>> all(counts.begin(), counts.end());
  std::ranges::stable_sort(all, std::greater{}, &std::pair<std::string, int>::second);
  std::vector<std::string> names;
  for (std::size_t i = 0; i < std::min(all.size(), most_named); ++i) names.push_back(all[i].first);
  const auto more = all.size() - names.size();
  return fmt::format("{}{}", fmt::join(names, ", "), more > 0 ? fmt::format(" and {} more", more) : "");
}

std::string where_it_wins(const LineScores& all, const std::string& line) {
  const auto found = all.of.find(line);
  if (found == all.of.end() || found->second.reached == 0) return "Reaches none of these accuracies.";
  auto of = found->second;
  if (of.won_on.empty()) {
    return fmt::format("Cheapest nowhere; nearest on {} to 1e{:.0f}, in {:.3g} times the least time.",
                       of.nearest_on, std::log10(of.nearest_accuracy), of.nearest);
  }
  std::string text = fmt::format("Cheapest in {} of {} cells: {}.", of.won(), all.cells, named(of.won_on));
  if (!of.margins.empty()) {
    const auto middle = of.margins.begin() + std::ssize(of.margins) / 2;
    std::ranges::nth_element(of.margins, middle);
    text += *middle < 1.05 ? " The next is as quick, in the median."
                           : fmt::format(" The next takes {:.2g} times as long, in the median.", *middle);
  }
  return text;
}

// The runs of a line with one bad verdict, counted by scene and by reason.
struct Counted {
  std::map<std::string, int> scenes{}, reasons{};
};

// The reason without its detail for one scene, as in "takes no algebraic rows: component 6 is one".
std::string general(const std::string& reason) { return reason.substr(0, reason.find(": component")); }

std::string against(const PageInput& page, const std::string& line) {
  std::map<std::string_view, Counted> counted;
  int trials = 0;
  const auto count = [&](const MeasuredRun& run) {
    if (page.label(run.key) != line) return;
    auto& of = counted[trial_result(run).word];
    ++of.scenes[run.key.scene.id];
    ++of.reasons[general(run.ending.detail)];
  };
  for (const MeasuredRun& run : page.trials) {
    trials += page.label(run.key) == line ? 1 : 0;
    count(run);
  }
  for (const MeasuredRun& run : page.runs.failed) {
    if (std::ranges::none_of(page.trials, [&](const MeasuredRun& trial) { return trial.key == run.key; }))
      count(run);
  }
  std::vector<std::string> parts;
  for (const TrialResult& of : {fails, inaccurate}) {
    if (const auto& scenes = counted[of.word].scenes; !scenes.empty())
      parts.push_back(fmt::format("{} on {}", of.word, named(scenes)));
  }
  if (const auto& [scenes, reasons] = counted[refuses.word]; !scenes.empty()) {
    const auto most = std::ranges::max_element(reasons, {}, &std::pair<const std::string, int>::second);
    parts.push_back(
        fmt::format("{} {}{}", refuses.word,
                    scenes.size() > most_named ? fmt::format("{} scenes", scenes.size()) : named(scenes),
                    most->first.empty() ? "" : fmt::format(" ({})", most->first)));
  }
  if (parts.empty() && trials == 0) return "";
  if (parts.empty())
    return trials == 1 ? "Survives its trial." : fmt::format("Survives all {} trials.", trials);
  auto text = fmt::format("{}.", fmt::join(parts, "; "));
  text.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(text.front())));
  return text;
}

// The labels of finished runs, failed runs and trials, without repetitions, in the order of the list of
// schemes.
std::vector<std::string> labels_of(const PageInput& page) {
  std::vector<std::string> labels;
  const auto add = [&](std::string_view id) {
    for (const auto* runs : {&page.runs.finished, &page.runs.failed, &page.trials}) {
      for (const MeasuredRun& run : *runs) {
        if (run.key.scheme != id) continue;
        if (auto label = page.label(run.key); std::ranges::count(labels, label) == 0)
          labels.push_back(std::move(label));
      }
    }
  };
  for (const auto& scheme : schemes()) add(scheme.id);
  return labels;
}

}  // namespace

std::map<std::string, int> cells_won(const PageInput& page, const ErrorKind& kind) {
  std::map<std::string, int> won;
  for (const auto& [line, standing] : standings_of(page, kind).of) won[line] = standing.won();
  return won;
}

Table scheme_verdicts(const PageInput& page, const ErrorKind& kind) {
  Table table{.caption = fmt::format("Each scheme, by {}: where it is cheapest, and what speaks against it",
                                     error_title(kind)),
              .columns = {{"scheme"}, {"where it wins"}, {"where not to use it"}}};
  auto all = standings_of(page, kind);
  auto labels = labels_of(page);
  std::ranges::stable_sort(labels, std::greater{}, [&](const auto& label) { return all.of[label].won(); });
  RowGroup rows;
  for (const auto& line : labels) {
    rows.rows.push_back(
        {{.text = line, .line = line}, {.text = where_it_wins(all, line)}, {.text = against(page, line)}});
  }
  if (!rows.rows.empty()) table.groups.push_back(std::move(rows));
  return table;
}

}  // namespace fde::bench
