// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/requests/exact.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <stdexcept>
#include <string_view>

#include "fdebench/benchmarks/references/decimal_bound.hpp"
#include "fdebench/benchmarks/references/reference_of.hpp"
#include "fdebench/benchmarks/scenes/start_time.hpp"
#include "fdebench/benchmarks/text/range.hpp"
#include "fdebench/benchmarks/text/refusal.hpp"
#include "fdebench/reference/special_functions/mittag_leffler/mittag_leffler.hpp"
#include "fdebench/schemes/problem/progress/progress.hpp"

namespace fde::bench {
namespace {

// Throws NumericalFailure unless `finite`. An energy or a bound may overflow where the columns do not.
void require_finite(bool finite, std::string_view what, std::string_view range, double t) {
  if (!finite) throw NumericalFailure(fmt::format("the {} is beyond {} at t = {}", what, range, t));
}

void require_times(const Scene& scene, const std::vector<double>& times) {
  const bool ends = is_two_sided(scene.problem);
  const double last = ends ? end_time(scene) : std::numeric_limits<double>::max();
  const Range allowed{.low = scene.start};
  for (const double t : times) {
    if (t >= scene.start && t <= last) continue;
    refuse_value(
        "times", fmt::format("{}", t),
        {ends ? fmt::format("in [{}, {}], the time of the scene", scene.start, last) : allowed.text()});
  }
}

// What `known` gives; a failure of a reference counts time from the start.
template <class Known>
auto with_times_of(const Scene& scene, const Known& known) {
  try {
    return known();
  } catch (const NumericalFailure&) {
    throw;
  } catch (const std::runtime_error& failure) {
    if (scene.start == 0.0) throw;
    throw std::runtime_error(with_note_of_start(scene, failure.what()));
  }
}

// Bounds of the errors of the singular values, 0 where they are infinite.
Vec singular_bounds(const Scene& scene, double t, const reference::ReferenceValue& columns, In values) {
  constexpr double rounding = 4.0 * std::numeric_limits<double>::epsilon();
  if (values.size() == 0 || t == 0.0) return Vec::Zero(values.size());
  return propagated_bound(scene.singular, t, columns, values) + rounding * values.cwiseAbs();
}

void announce(const BeforeTime& before, double t) {
  if (before) before(t);
}

}  // namespace

ExactTable exact(Scene scene, const std::vector<double>& times, const BeforeTime& before) {
  require_times(scene, times);
  const double last = times.empty() ? 0.0 : from_start(scene, std::ranges::max(times));
  if (!is_two_sided(scene.problem) && last > 0.0) set_end(scene, last);
  ExactTable table{.names = printed_names(scene)};
  const bool has_multipliers = scene.reactions.has_exact_multipliers();
  if (has_multipliers) std::ranges::copy(reaction_names(scene), std::back_inserter(table.names));
  table.values.resize(std::ssize(table.names), std::ssize(times));
  const auto singular = std::ssize(scene.singular.names);
  table.bounds.resize(std::ssize(scene.outputs.names) + singular, std::ssize(times));
  announce(before, end_time(scene));
  const reference::Reference known = with_times_of(scene, [&] { return reference_of(scene); });
  for (Eigen::Index i = 0; const double time : times) {
    announce(before, time);
    const double t = from_start(scene, time);
    const auto [columns, bounds] = with_times_of(scene, [&] { return known.at(t); });
    report_progress(1, 1);
    require_finite(columns.allFinite(), "exact solution", "double", time);
    require_finite(bounds.allFinite(), "bound of the exact solution", "double", time);
    const Vec values = printed_values(scene, t, columns);
    for (Eigen::Index c = columns.size(); c < values.size(); ++c) {
      require_finite(std::isfinite(values[c]) || !is_regular(scene, t, c),
                     "exact " + table.names[static_cast<std::size_t>(c)], "double", time);
    }
    table.values.col(i).head(values.size()) = values;
    if (has_multipliers) {
      const Vec multipliers = exact_reactions(scene, t, columns);
      table.values.col(i).tail(multipliers.size()) = multipliers;
    }
    table.bounds.col(i++) << bounds,
        singular_bounds(scene, t, {columns, bounds}, values.segment(columns.size(), singular));
  }
  return table;
}

std::vector<std::vector<reference::Decimal>> exact_in_digits(const Scene& scene, std::string_view id,
                                                             const std::vector<double>& times, int digits,
                                                             const BeforeTime& before) {
  require_times(scene, times);
  if (!scene.reference.digits) {
    throw Refusal(
        {RequestField{"digits"},
         fmt::format(" = {}: scene {} has no exact solution in digits, only what is known in double", digits,
                     id)});
  }
  require_in("digits", digits, CountRange{1, reference::max_digits});
  if (scene.from_file) require_agreement(scene, scene.reference);
  std::vector<std::vector<reference::Decimal>> rows;
  for (const double t : times) {
    announce(before, t);
    rows.push_back(scene.reference.digits(from_start(scene, t), digits));
    report_progress(1, 1);
    for (const auto& decimal : rows.back())
      require_finite(is_finite_bound(decimal.bound), "exact solution", "all exponents", t);
  }
  return rows;
}

}  // namespace fde::bench
