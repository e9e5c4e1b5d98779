// SPDX-License-Identifier: MIT
// winners [SCENE...]: the quickest scheme within each accuracy, and the observed rate and cost of a step of
// each scheme. Prints the table of docs/which_scheme.md. Errors are at the end time.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <set>
#include <string>

#include "fdebench/benchmarks/programs/figures.hpp"
#include "fdebench/benchmarks/records/run_settings.hpp"
#include "fdebench/benchmarks/references/memoized_reference.hpp"
#include "fdebench/benchmarks/scenes/variant.hpp"
#include "fdebench/benchmarks/search/search.hpp"

namespace fde::bench::figures {
namespace {

constexpr std::array scenes_of_all{"relaxation",      "relaxation:gamma=1.5",
                                   "relaxation_pair", "stiff_relaxation",
                                   "power",           "diethelm",
                                   "linear_system",   "fractional_oscillator",
                                   "bagley_torvik",   "damped_oscillator",
                                   "brusselator",     "pendulum"};
constexpr std::array accuracies{1e-4, 1e-6, 1e-8, 1e-10, 1e-12};

std::string time_of(double seconds) {
  return seconds < 1e-3 ? fmt::format("{:.3g} µs", 1e6 * seconds) : fmt::format("{:.3g} ms", 1e3 * seconds);
}

// "`l1`, graded:3, 12: 12 µs": scheme, grid if not uniform, steps (or requested tolerance) and time.
std::string cell(const SearchCandidate& first) {
  if (first.outcome != SearchOutcome::accuracy_reached) return "-";
  const auto grid = first.configuration.grading == 1.0 ? "" : ", " + grid_text(first.configuration.grading);
  const auto* tolerance = std::get_if<Tolerance>(&first.best.resolution);
  const auto requested = tolerance != nullptr ? fmt::format("tolerance {:.1e}", tolerance->rtol)
                                              : fmt::format("{}", first.best.steps);
  return fmt::format("`{}`{}, {}: {}", first.names.front(), grid, requested, time_of(first.time->median));
}

// The rate and the cost of a step of each scheme, on the grid with the largest rate.
std::string reasons(std::vector<SearchCandidate> found) {
  std::ranges::stable_sort(found, std::greater<>{},
                           [](const SearchCandidate& way) { return way.rate.value_or(0.0); });
  std::set<std::string_view> printed;
  std::string text;
  for (const auto& way : found) {
    if (!way.rate || way.refinement.runs.empty() || !printed.insert(way.configuration.scheme->id).second)
      continue;
    text += fmt::format("{}{} {:.1f} ({}, {:.0f} ns a step)", text.empty() ? "" : "; ", way.names.front(),
                        *way.rate, grid_text(way.configuration.grading), 1e9 * way.seconds_per_step);
  }
  return text;
}

// Prints the row of a scene; returns the text of reasons() for it.
std::string tell(const std::string& label) {
  const Scene scene = make_scene(parse_variant(label));
  fmt::print("| `{}`", label);
  std::vector<SearchCandidate> found;
  for (const double accuracy : accuracies) {
    const AccuracyTarget target{{Norm::end, Scale::mixed}, accuracy, all_columns(scene)};
    found = search(scene, target, 60.0, [](const std::string&, double) {});
    fmt::print(" | {}", cell(found.front()));
    std::fflush(stdout);
  }
  fmt::print(" |\n");
  return fmt::format("\n`{}`: {}.\n", label, reasons(std::move(found)));
}

}  // namespace

void winners(const Words& scenes) {
  fmt::print("| scene | 1e-4 | 1e-6 | 1e-8 | 1e-10 | 1e-12 |\n|---|---|---|---|---|---|\n");
  std::string reasons = "\nRates seen, with the cost of a step:\n";
  for (const auto& scene : scenes.empty() ? Words(scenes_of_all.begin(), scenes_of_all.end()) : scenes)
    reasons += tell(scene);
  fmt::print("{}", reasons);
}

}  // namespace fde::bench::figures
