// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/references/verified_reference.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <string_view>
#include <utility>
#include <vector>

#include "fdebench/benchmarks/references/reference_of.hpp"
#include "fdebench/schemes/stepping/scheme.hpp"

namespace fde::bench {
namespace {

constexpr std::array<std::string_view, 2> judges{"radau_exponentials", "spectral_collocation"};

// The columns at these times, one row a column, computed by this scheme; nullopt if it cannot.
std::optional<Rows> coarse_run(std::string_view id, const PosedProblem& posed,
                               const std::vector<double>& times, double size) {
  constexpr double tolerance = 1e-5, seconds = 2.0;
  const Scheme& scheme = *find_scheme(id);
  const Tolerance requested{tolerance, tolerance * size};
  if (unsupported_reason(scheme, posed.problem, requested)) return std::nullopt;
  const Trajectory path = scheme.solve(posed.problem, requested, {.budget = seconds, .output_times = times});
  if (path.status != SolveStatus::finished || path.times != times) return std::nullopt;
  return columns_of(posed.outputs, path);
}

}  // namespace

void require_agreement(const Scene& scene, const reference::Reference& reference) {
  const auto posed = scene.ill_posed_reason.empty() ? PosedProblem{scene.problem, scene.outputs}
                                                    : reference_problem_of(scene);
  constexpr double agree = 1e-3, differ = 1e-2;
  const double end = posed.problem.end;
  const std::vector<double> times{end / 7.0, end / 2.0, end};
  Rows known(std::ssize(posed.outputs.names), std::ssize(times)), bound = known;
  for (Eigen::Index c = 0; c < known.cols(); ++c) {
    const reference::ReferenceValue value = reference.at(times[static_cast<std::size_t>(c)]);
    known.col(c) = value.value;
    bound.col(c) = value.bound;
  }
  if (!known.allFinite()) return;
  const double largest = known.cwiseAbs().maxCoeff(), size = largest == 0.0 ? 1.0 : largest;
  std::array<Rows, judges.size()> runs;
  for (std::size_t s = 0; s < judges.size(); ++s) {
    auto run = coarse_run(judges[s], posed, times, size);
    if (!run || !run->allFinite()) return;
    runs[s] = std::move(*run);
  }
  const auto& [one, other] = runs;
  for (Eigen::Index i = 0; i < known.rows(); ++i) {
    const double scale = std::max(known.row(i).cwiseAbs().maxCoeff(), one.row(i).cwiseAbs().maxCoeff());
    for (Eigen::Index c = 0; c < known.cols(); ++c) {
      if (std::abs(one(i, c) - other(i, c)) > agree * scale) continue;
      if (std::abs(known(i, c) - one(i, c)) <= differ * scale + bound(i, c)) continue;
      throw std::runtime_error(fmt::format(
          "what is known of {} at t = {:.6g} is not believed: it says {:.10g}, {} says {:.6g} and {} {:.6g}",
          posed.outputs.names[static_cast<std::size_t>(i)], times[static_cast<std::size_t>(c)], known(i, c),
          judges[0], one(i, c), judges[1], other(i, c)));
    }
  }
}

}  // namespace fde::bench
