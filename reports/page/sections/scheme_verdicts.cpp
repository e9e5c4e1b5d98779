#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "analysis/text.hpp"
#include "analysis/verdict.hpp"
#include "page/accuracies.hpp"
#include "page/page_data.hpp"
#include "stepping/scheme.hpp"

namespace fde {
namespace {

constexpr std::size_t most_named = 3;  // scenes in a sentence

// What a line is worth in the map of answers.
struct Standing {
  std::vector<double> margins{};        // of the second line's time to its own, in the cells that it wins
  std::map<std::string, int> won_on{};  // scenes
  double nearest = INFINITY;            // the least of its time to the winner's
  std::string nearest_on{};             // the scene of that
  double nearest_accuracy = 0.0;
  int reached = 0;  // cells
};

struct Standings {
  std::map<std::string, Standing> of{};  // by the labels of lines
  int cells = 0;                         // that some line wins
};

Standings standings_of(const PageInput& page, const ErrorKind& kind) {
  Standings found;
  for (const RunSpan runs : by_scene(page.runs.finished)) {
    const auto& scene = runs.front().key.scene;
    const SceneLines lines(page.runs, scene);
    for (const double accuracy : accuracies) {
      const auto ranked = lines.within(kind, accuracy);
      if (ranked.empty()) continue;
      ++found.cells;
      auto& winner = found.of[page.label(ranked.front())];
      ++winner.won_on[label_of(scene)];
      if (ranked.size() > 1) winner.margins.push_back(ranked[1].time.median / ranked.front().time.median);
      for (const Option& option : ranked) {
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

// The names that count most, and how many more there are.
std::string named(const std::map<std::string, int>& counts) {
  std::vector<std::pair<std::string, int>> all(counts.begin(), counts.end());
  std::ranges::stable_sort(all, std::greater{}, &std::pair<std::string, int>::second);
  std::vector<std::string> names;
  for (std::size_t i = 0; i < std::min(all.size(), most_named); ++i) names.push_back(all[i].first);
  const auto more = all.size() - names.size();
  return fmt::format("{}{}", fmt::join(names, ", "), more > 0 ? fmt::format(" and {} more", more) : "");
}

std::string where_it_wins(const Standings& all, const std::string& line) {
  const auto found = all.of.find(line);
  if (found == all.of.end()) return "reaches none of these accuracies";
  auto of = found->second;
  if (of.won_on.empty()) {
    return fmt::format("cheapest nowhere; nearest on {} to 1e{:.0f}, in {:.3g} times the least time",
                       of.nearest_on, std::log10(of.nearest_accuracy), of.nearest);
  }
  int won = 0;
  for (const auto& [scene, cells] : of.won_on) won += cells;
  std::string text = fmt::format("cheapest in {} of {} cells: {}", won, all.cells, named(of.won_on));
  if (!of.margins.empty()) {
    const auto middle = of.margins.begin() + std::ssize(of.margins) / 2;
    std::ranges::nth_element(of.margins, middle);
    text += fmt::format("; the next takes {:.2g} times as long, in the median", *middle);
  }
  return text;
}

// Runs of a line that a verdict speaks against.
struct Counted {
  int runs = 0;
  std::map<std::string, int> scenes{}, reasons{};
};

std::string against(const PageInput& page, const std::string& line) {
  std::map<std::string_view, Counted> counted;
  int trials = 0;
  const auto count = [&](const MeasuredRun& run) {
    if (page.label(run.key) != line) return;
    auto& of = counted[verdict(run).word];
    ++of.runs;
    ++of.scenes[run.key.scene.id];
    ++of.reasons[run.ending.detail];
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
  for (const Verdict& of : {fails, inaccurate}) {
    if (const auto& [runs, scenes, reasons] = counted[of.word]; runs > 0) {
      parts.push_back(fmt::format("{} {} ({})", of.word, runs == 1 ? "once" : fmt::format("{} times", runs),
                                  named(scenes)));
    }
  }
  if (const auto& [runs, scenes, reasons] = counted[refuses.word]; runs > 0) {
    const auto most = std::ranges::max_element(reasons, {}, &std::pair<const std::string, int>::second);
    parts.push_back(
        fmt::format("refuses {}{}", named(scenes), most->first.empty() ? "" : ": " + most->first));
  }
  if (parts.empty()) return trials > 0 ? fmt::format("survives all {} trials", trials) : "";
  return fmt::format("{}", fmt::join(parts, "; "));
}

// Of finished runs, failed ones and trials, each once, in the order of the list of schemes.
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

Table scheme_verdicts(const PageInput& page, const ErrorKind& kind) {
  Table table{.caption = fmt::format("Each scheme, by {}: where it is cheapest, and what speaks against it",
                                     error_title(kind)),
              .columns = {{"scheme"}, {"where it wins"}, {"where not to use it"}}};
  const auto all = standings_of(page, kind);
  RowGroup rows;
  for (const auto& line : labels_of(page)) {
    rows.rows.push_back(
        {{.text = line, .line = line}, {.text = where_it_wins(all, line)}, {.text = against(page, line)}});
  }
  if (!rows.rows.empty()) table.groups.push_back(std::move(rows));
  return table;
}

}  // namespace fde
