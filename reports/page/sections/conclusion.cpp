// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <vector>

#include "fdebench/reports/analysis/text.hpp"
#include "fdebench/reports/page/accuracies.hpp"
#include "fdebench/reports/page/page_data.hpp"

namespace fde::bench {
namespace {

std::string accuracy_name(double accuracy) { return fmt::format("1e{:.0f}", std::log10(accuracy)); }

// Consecutive accuracies with the same cheapest line.
struct AccuracyRange {
  RecommendedRun first, last;
  double from = 0.0, to = 0.0;
};

std::vector<AccuracyRange> stretches(const PageInput& page, const SceneLines& lines, const ErrorKind& kind) {
  std::vector<AccuracyRange> found;
  for (const double accuracy : accuracies) {
    const auto ranked = lines.within(kind, accuracy);
    if (ranked.empty()) break;
    if (!found.empty() && page.label(found.back().last) == page.label(ranked.front())) {
      found.back().last = ranked.front();
      found.back().to = accuracy;
    } else {
      found.push_back({ranked.front(), ranked.front(), accuracy, accuracy});
    }
  }
  return found;
}

std::string stretch_text(const PageInput& page, const AccuracyRange& of) {
  const bool one = of.from == of.to;
  const auto first = time_text(of.first.time.median), last = time_text(of.last.time.median);
  return fmt::format(
      "{} {}{} ({})", page.label(of.first), one ? "to " : "from ",
      one ? accuracy_name(of.from) : fmt::format("{} to {}", accuracy_name(of.from), accuracy_name(of.to)),
      first == last ? first : fmt::format("{} to {}", first, last));
}

// Why no run is within this accuracy, the first that none reaches.
std::string limit(const PageInput& page, const SceneLines& lines, RunSpan runs, const ErrorKind& kind,
                  double accuracy) {
  const auto missed = lines.shortfall(kind, accuracy, {});
  if (!missed || missed->untimed > 0) return {};
  std::string text = fmt::format("No run is within {}: the best has {}, by {}", accuracy_name(accuracy),
                                 error_text(missed->best.error), page.label(missed->best));
  const auto best = std::ranges::find_if(runs, [&](const MeasuredRun& run) {
    return run.key.scheme == missed->best.schemes.front() && run.key.setup == missed->best.setup;
  });
  if (best == runs.end()) return text + ".";
  const auto rounding = (*best)["rounding"], bound = (*best)["reference_bound_maximum"];
  if (rounding && *rounding >= 0.25 * missed->best.error) return text + ", which is rounding.";
  if (bound && *bound >= 0.1 * missed->best.error) return text + ", as far as the reference is known.";
  return text + ".";
}

// The lines with failed or refused runs on the scene.
std::string left_out(const PageInput& page, const SceneSettings& scene) {
  std::set<std::string> refused, ended;
  for (const MeasuredRun& run : of_scene(page.runs.failed, scene))
    (run.ending.kind == SolveStatus::refused ? refused : ended).insert(page.label(run.key));
  std::vector<std::string> parts;
  if (!ended.empty()) parts.push_back(fmt::format("Some runs of {} end early", fmt::join(ended, ", ")));
  if (!refused.empty()) {
    parts.push_back(fmt::format("{} {} it, with {}", count_text(static_cast<double>(refused.size())),
                                refused.size() == 1 ? "scheme refuses" : "schemes refuse",
                                "the reason under Refused and failed"));
  }
  return parts.empty() ? "" : fmt::format("{}.", fmt::join(parts, ". "));
}

}  // namespace

std::string conclusion(const PageInput& page, const SceneLines& lines, RunSpan runs, const ErrorKind& kind) {
  const SceneSettings& scene = runs.front().key.scene;
  const auto found = stretches(page, lines, kind);
  std::vector<std::string> sentences;
  if (!found.empty()) {
    std::vector<std::string> parts;
    for (const AccuracyRange& stretch : found) parts.push_back(stretch_text(page, stretch));
    sentences.push_back(fmt::format("Cheapest: {}.", fmt::join(parts, ", then ")));
    const auto ranked = lines.within(kind, found.back().to);
    const auto to = accuracy_name(found.back().to), name = page.label(ranked.front());
    sentences.push_back(ranked.size() == 1
                            ? fmt::format("Only {} reaches {}.", name, to)
                            : fmt::format("To {} {} leads: {}.", to, name,
                                          reason_for_speed(page, scene, ranked[0], ranked[1], kind.norm)));
  }
  const double reached = found.empty() ? 1.0 : found.back().to;
  const auto* const next =
      std::ranges::find_if(accuracies, [&](double accuracy) { return accuracy < 0.5 * reached; });
  if (next != accuracies.end()) {
    if (auto text = limit(page, lines, runs, kind, *next); !text.empty()) sentences.push_back(text);
  }
  if (auto text = left_out(page, scene); !text.empty()) sentences.push_back(text);
  return fmt::format("{}", fmt::join(sentences, " "));
}

}  // namespace fde::bench
