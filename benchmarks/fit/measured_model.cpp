// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/fit/measured_model.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include "fdebench/benchmarks/measures/run_outcome.hpp"
#include "fdebench/benchmarks/references/memoized_reference.hpp"
#include "fdebench/benchmarks/text/refusal.hpp"

namespace fde::bench {
namespace {

Vec sizes_of(const Rows& values) {
  Vec sizes(values.rows());
  for (Eigen::Index c = 0; c < sizes.size(); ++c) {
    sizes[c] = 0.0;
    for (const double value : values.row(c))
      if (std::isfinite(value)) sizes[c] = std::max(sizes[c], std::abs(value));
  }
  return sizes;
}

// The smallest size that is not 0; 1 if all are.
double smallest_of(const Vec& sizes) {
  double least = std::numeric_limits<double>::infinity();
  for (const double size : sizes)
    if (size > 0.0) least = std::min(least, size);
  return std::isfinite(least) ? least : 1.0;
}

}  // namespace

MeasuredModel::MeasuredModel(SceneVariant scene, const Scene& posed, std::vector<std::string> parameters,
                             ExternalTrajectory measured, const Scheme& scheme)
    : scene_(std::move(scene)),
      parameters_(std::move(parameters)),
      measured_(std::move(measured)),
      scheme_(scheme),
      sizes_(sizes_of(measured_.values)),
      size_(smallest_of(sizes_)) {
  if (!is_two_sided(posed.problem)) scene_.until = measured_.times.back();
  for (const Eigen::Index column : measured_.columns)
    names_.push_back(posed.outputs.names[static_cast<std::size_t>(column)]);
  for (const double t : measured_.times) {
    if (times_.empty() || t > times_.back()) times_.push_back(t);
    time_.push_back(std::ssize(times_) - 1);
  }
}

void MeasuredModel::set_accuracy(double accuracy) {
  accuracy_ = accuracy;
  seconds_.reset();
}

SceneVariant MeasuredModel::at(const Vec& theta) const {
  SceneVariant variant = scene_;
  for (std::size_t i = 0; i < parameters_.size(); ++i)
    variant.values[parameters_[i]] = theta[static_cast<Eigen::Index>(i)];
  return variant;
}

std::optional<std::vector<Eigen::Index>> MeasuredModel::places_in(const Scene& scene) const {
  std::vector<Eigen::Index> places;
  for (const auto& name : names_) {
    const auto found = std::ranges::find(scene.outputs.names, name);
    if (found == scene.outputs.names.end()) return std::nullopt;
    places.push_back(found - scene.outputs.names.begin());
  }
  return places;
}

// Changes the size only where the columns have another order of magnitude: a change of the tolerance changes
// the errors of runs, which are noise in differences between runs.
void MeasuredModel::adjust_size(const Rows& columns) {
  constexpr double far = 10.0;
  const double size = std::min(smallest_of(sizes_), smallest_of(sizes_of(columns)));
  if (size < size_ / far || size > size_ * far) size_ = size;
}

std::optional<Rows> MeasuredModel::columns(const Vec& theta) {
  constexpr double longest_first = 60.0, far = 30.0, shortest = 1.0;  // of the first run with this accuracy
  const auto fail = [&](std::string why) {
    why_none_ = std::move(why);
    return std::optional<Rows>();
  };
  ++solves_;
  try {
    const Scene scene = make_scene(at(theta));
    const Tolerance tolerance{.rtol = accuracy_, .atol = accuracy_ * size_};
    if (const auto reason = unsupported_reason(scheme_, scene.problem, tolerance)) return fail(*reason);
    const auto places = places_in(scene);
    if (!places) return fail(fmt::format("the scene has no longer the columns {}", fmt::join(names_, ", ")));
    auto events = events_of(scene);
    std::erase_if(events, [](const Event& event) { return !event.terminal; });
    const auto start = std::chrono::steady_clock::now();
    const auto path = scheme_.solve(scene.problem, tolerance,
                                    {.budget = seconds_ ? std::max(shortest, far * *seconds_) : longest_first,
                                     .output_times = times_,
                                     .events = std::move(events)});
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
    if (path.status != SolveStatus::finished) return fail(describe(scene.problem, path));
    if (!seconds_) seconds_ = taken.count();
    const Rows columns = columns_of(scene.outputs, path);
    if (!columns.allFinite()) return fail("a column is not finite");
    Rows of_measurements = columns(*places, time_);
    adjust_size(of_measurements);
    return of_measurements;
  } catch (const std::invalid_argument& refused) {
    return fail(refused.what());
  }
}

Rows MeasuredModel::exact_columns(const Vec& theta) const {
  const Scene scene = make_scene(at(theta));
  MemoizedReference reference(scene);
  return reference.at(times_)(places_in(scene).value(), time_);
}

const Scheme& adaptive_scheme_for(const Problem& problem, const std::optional<std::string>& id) {
  const Tolerance any{.rtol = 1e-6, .atol = 1e-6};
  std::optional<std::string> reason;
  for (const Scheme& scheme : schemes()) {
    if (!scheme.capabilities.is_adaptive() || (id && scheme.id != *id)) continue;
    reason = unsupported_reason(scheme, problem, any);
    if (!reason) return scheme;
  }
  if (reason && id) throw Refusal({RequestField{"scheme"}, fmt::format(" = {}: {}", *id, *reason)});
  if (reason) throw Refusal({fmt::format("no scheme with adaptive step size takes the scene: {}", *reason)});
  std::vector<std::string_view> adaptive;
  for (const Scheme& scheme : schemes())
    if (scheme.capabilities.is_adaptive()) adaptive.push_back(scheme.id);
  refuse_value("scheme", *id, {fmt::format("one with adaptive step size: {}", fmt::join(adaptive, ", "))});
}

}  // namespace fde::bench
