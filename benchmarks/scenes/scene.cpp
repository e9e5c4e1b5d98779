// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/scenes/scene.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "fdebench/schemes/problem/delays.hpp"

namespace fde::bench {

Outputs select_components(std::vector<std::string> names, std::vector<Eigen::Index> components) {
  return {std::move(names), [components = std::move(components)](double, In y, Out columns) {
            for (std::size_t c = 0; c < components.size(); ++c)
              columns[static_cast<Eigen::Index>(c)] = y[components[c]];
          }};
}

double Constraint::drift(double t, In columns) const {
  Vec f(size);
  value(t, columns, f);
  return f.lpNorm<Eigen::Infinity>();
}

double Constraint::terms(double t, In columns) const {
  Vec all(size), without(size), sum = Vec::Zero(size);
  value(t, columns, all);
  Vec others = columns;
  for (Eigen::Index i = 0; i < others.size(); ++i) {
    others[i] = 0.0;
    value(t, others, without);
    others[i] = columns[i];
    if (without.allFinite()) sum += (all - without).cwiseAbs();
  }
  return sum.lpNorm<Eigen::Infinity>();
}

void set_end(Scene& scene, double end) {
  if (scene.reference_to && end != scene.problem.end) scene.reference = scene.reference_to(end);
  scene.problem.end = end;
  if (scene.load_times) {
    auto times = scene.load_times(end);
    scene.problem.jump_times = std::move(times.jumps);
    scene.problem.kink_times = std::move(times.kinks);
    scene.problem.step_limits = std::move(times.limits);
  }
  add_jumps_of_start(scene.problem);
}

Vec columns_at(const Outputs& outputs, double t, In y) {
  if (!outputs.evaluate) return y;
  Vec columns(static_cast<Eigen::Index>(outputs.names.size()));
  outputs.evaluate(t, y, columns);
  return columns;
}

std::vector<std::string> printed_names(const Scene& scene) {
  auto names = scene.outputs.names;
  std::ranges::copy(scene.singular.names, std::back_inserter(names));
  if (scene.energy) names.emplace_back("energy");
  if (scene.constraint) names.emplace_back("constraint");
  return names;
}

Vec printed_values(const Scene& scene, double t, In columns) {
  // A copy, because the alignment of a matrix column changes the order in which Eigen sums.
  const Vec own = columns;
  Vec values(std::ssize(printed_names(scene)));
  values.head(own.size()) = own;
  Eigen::Index next = own.size();
  if (const auto count = std::ssize(scene.singular.names); count > 0) {
    scene.singular.evaluate(t, own, values.segment(next, count));
    next += count;
  }
  if (scene.energy) values[next++] = scene.energy.value(own);
  if (scene.constraint) values[next++] = scene.constraint.drift(t, own);
  return values;
}

bool is_regular(const Scene& scene, double t, Eigen::Index printed) {
  const auto place = printed - std::ssize(scene.outputs.names);
  return t > 0.0 || place < 0 || place >= std::ssize(scene.singular.names);
}

std::vector<Event> events_of(const Scene& scene) {
  std::vector<Event> events;
  for (const auto& one : scene.events) {
    const auto value = [&one, &outputs = scene.outputs](double t, In y) {
      return one.value(t, columns_at(outputs, t, y));
    };
    events.push_back({.value = value, .crossing = one.crossing, .terminal = one.terminal});
    if (one.times) events.back().times = one.times(scene.problem.end);
  }
  return events;
}

std::vector<std::string> reaction_names(const Scene& scene) {
  auto names = scene.reactions.names;
  if (scene.reactions) names.emplace_back("power");
  return names;
}

Vec with_reaction_power(const Scene& scene, double t, In columns, const Vec& lambda) {
  Vec values(lambda.size() + 1);
  values << lambda, scene.reactions.power(t, columns, lambda);
  return values;
}

Vec reaction_values(const Scene& scene, double t, In columns, const std::optional<Vec>& rates) {
  const auto& [names, rated, powers, multipliers, power, first, exact] = scene.reactions;
  const auto size = std::ssize(names);
  if (!rated.empty() && !rates) {
    if (!first) return Vec::Constant(size + 1, std::numeric_limits<double>::quiet_NaN());
    return with_reaction_power(scene, t, columns, *first);
  }
  Vec lambda(size);
  multipliers(t, columns, rates.value_or(Vec()), lambda);
  return with_reaction_power(scene, t, columns, lambda);
}

Vec exact_reactions(const Scene& scene, double t, In columns) {
  if (scene.reactions.depends_on_columns_only() || t == 0.0)
    return reaction_values(scene, t, columns, std::nullopt);
  return with_reaction_power(scene, t, columns, scene.reactions.exact.at(t).value);
}

Rows columns_of(const Outputs& outputs, const Trajectory& path) {
  if (!outputs.evaluate) return path.y;
  Rows columns(static_cast<Eigen::Index>(outputs.names.size()), path.y.cols());
  for (Eigen::Index c = 0; c < path.y.cols(); ++c) {
    outputs.evaluate(path.time(c), path.y.col(c), columns.col(c));
  }
  return columns;
}

// For a column that is a component the difference quotient is exactly 1.
Vec propagated_bound(const Outputs& outputs, double t, const reference::ReferenceValue& reference,
                     In columns) {
  Vec bound = Vec::Zero(columns.size()), shifted = reference.value;
  for (Eigen::Index i = 0; i < shifted.size(); ++i) {
    shifted[i] += 0x1p-26 * std::max(std::abs(shifted[i]), 1.0);
    const Vec quotient = (columns_at(outputs, t, shifted) - columns) / (shifted[i] - reference.value[i]);
    for (Eigen::Index c = 0; c < bound.size() && reference.bound[i] != 0.0; ++c)
      if (quotient[c] != 0.0) bound[c] += std::abs(quotient[c]) * reference.bound[i];
    shifted[i] = reference.value[i];
  }
  return bound;
}

std::complex<double> frequency_response(const TransferFunction& transfer, double frequency) {
  const std::complex<double> log_s(std::log(frequency), 0.5 * std::numbers::pi);
  const auto sum = [&](const std::vector<TransferFunction::Term>& terms) {
    std::complex<double> value;
    for (const auto& [coefficient, order] : terms) value += coefficient * std::exp(order * log_s);
    return value;
  };
  return sum(transfer.numerator) / sum(transfer.denominator);
}

}  // namespace fde::bench
