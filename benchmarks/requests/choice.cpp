// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/requests/choice.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <set>
#include <utility>

#include "fdebench/benchmarks/observers/comparison_steps.hpp"
#include "fdebench/benchmarks/references/memoized_reference.hpp"
#include "fdebench/benchmarks/references/reference_of.hpp"
#include "fdebench/benchmarks/requests/failure.hpp"
#include "fdebench/benchmarks/requests/own_scheme.hpp"
#include "fdebench/benchmarks/requests/recommendation_from_search.hpp"
#include "fdebench/benchmarks/requests/solve_request.hpp"
#include "fdebench/benchmarks/scenes/start_time.hpp"
#include "fdebench/benchmarks/search/estimated_reference.hpp"
#include "fdebench/benchmarks/search/search.hpp"
#include "fdebench/benchmarks/sweep/measured_run.hpp"
#include "fdebench/benchmarks/text/number_text.hpp"
#include "fdebench/benchmarks/text/output_text.hpp"
#include "fdebench/benchmarks/text/printable.hpp"

namespace fde::bench {
namespace {

// The indices of these columns, or of all.
std::vector<Eigen::Index> columns_of(const Scene& scene, const std::vector<std::string>& requested) {
  if (requested.empty()) return all_columns(scene);
  const auto& names = scene.outputs.names;
  std::vector<Eigen::Index> columns;
  for (const auto& name : requested) {
    const auto found = std::ranges::find(names, name);
    if (found == names.end()) reject_text("columns", name, fmt::format("of {}", fmt::join(names, ", ")));
    columns.push_back(found - names.begin());
  }
  return columns;
}

// From the reference, at times that are independent of any grid.
std::vector<SmallColumn> small_columns(const Scene& scene, const AccuracyTarget& target) {
  constexpr int evenly = 128;
  std::vector<std::string> names;
  std::vector<double> largest(target.columns.size(), 0.0);
  for (const auto column : target.columns)
    names.push_back(scene.outputs.names[static_cast<std::size_t>(column)]);
  for (const double t : comparison_times(scene.problem, evenly)) {
    const Vec values = scene.reference.at(t).value;
    for (std::size_t i = 0; i < largest.size(); ++i)
      largest[i] = std::max(largest[i], std::abs(values[target.columns[i]]));
  }
  return small_columns(target.kind, target.accuracy, names, largest);
}

// The scheme of a run, ours or the caller's.
const Scheme& scheme_of(const RecommendedRun& run, const std::vector<const Scheme*>& own) {
  const auto& id = run.schemes.front();
  const auto found = std::ranges::find(own, id, [](const Scheme* scheme) { return scheme->id; });
  return found != own.end() ? **found : scheme_named(id);
}

// Runs the best option of each scheme again, and takes the measures of the caller.
void take_measures(const Scene& scene, const ChoiceRequest& request, const SearchProgress& tell,
                   Recommendation& made) {
  if (request.measures.empty()) return;
  MemoizedReference reference(scene);
  std::set<std::string> measured;
  for (RecommendedRun& option : made.options) {
    if (!measured.insert(option.schemes.front()).second) continue;
    tell(fmt::format("measures {}", option.schemes.front()), 1.0);
    const Record run = examine(made.scene, scene, reference, scheme_of(option, request.schemes),
                               option.settings, request.measures);
    for (const auto& measure : request.measures)
      if (const auto value = run[measure.id]) option.measured.set(measure.id, *value);
  }
}

}  // namespace

bool parse_first_run(std::string_view text) {
  if (text != "1" && text != "many") reject_text("runs", text, "1 or many");
  return text == "1";
}

Recommendation choose(Scene scene, const ChoiceRequest& request, const SceneSettings& settings,
                      const SearchProgress& progress) {
  constexpr double part_of_estimate = 1.0 / 3.0;
  require_in("error", request.error, searched_errors);
  require_in("seconds", request.seconds, searched_seconds);
  require_own_ids(request.schemes);
  require_own_measures(request.measures);
  const AccuracyTarget target{request.kind, request.error, columns_of(scene, request.columns),
                              request.first_run};
  const SearchProgress tell = progress ? progress : [](const std::string&, double) {};
  const auto start = std::chrono::steady_clock::now();
  const bool at_points_only = is_examined_at_points_only(scene);
  auto known = reference_or_estimate(scene, target, part_of_estimate * request.seconds, tell);
  scene.reference = std::move(known.reference);
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
  const auto found =
      search(scene, target, std::max(0.0, request.seconds - taken.count()), tell, request.schemes);
  auto made = recommend(found, settings, scene.outputs.names, target, known.estimate);
  for (auto& missing : made.missing) missing = with_note_of_start(scene, missing);
  made.small = small_columns(scene, target);
  made.examined_at_points_only = at_points_only;
  made.columns = request.columns;
  require_option(made);
  take_measures(scene, request, tell, made);
  return made;
}

void require_option(const Recommendation& made) {
  if (!made.options.empty()) return;
  auto missing = made.missing;
  if (made.estimate) missing.push_back(estimate_text(*made.estimate));
  const auto columns = made.columns.empty() ? "" : fmt::format(", in {}", fmt::join(made.columns, ", "));
  throw NumericalFailure(fmt::format("no run of {} is within {} ({}{}): {}", label_of(made.scene),
                                     error_text(made.accuracy), kind_text(made.kind), columns,
                                     fmt::join(missing, "; ")));
}

}  // namespace fde::bench
