// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/requests/own_scheme.hpp"

#include <fmt/format.h>

#include <cstddef>
#include <optional>
#include <set>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "fdebench/benchmarks/text/number_text.hpp"
#include "fdebench/benchmarks/text/printable.hpp"
#include "fdebench/schemes/stepping/run.hpp"
#include "fdebench/schemes/stepping/with_conditions.hpp"

namespace fde::bench {
namespace {

std::vector<double> times_of(const Grid& grid) {
  std::vector<double> times;
  for (int n = 0; n <= grid.steps; ++n) times.push_back(grid.time(n));
  return times;
}

void require_shape(std::string_view id, const Rows& y, Eigen::Index components, std::size_t times) {
  if (y.rows() == components && static_cast<std::size_t>(y.cols()) == times) return;
  throw std::invalid_argument(
      fmt::format("scheme {}: returned {} x {} states, must be {} components x {} times", id, y.rows(),
                  y.cols(), components, times));
}

Trajectory run_of(std::string_view id, const StatesOfRun& states, const Problem& problem, const Grid& grid,
                  const Options& options) {
  Run run(problem, options, grid.steps);
  run.cost().rhs_calls = std::nullopt;  // the caller's own
  const auto times = times_of(grid);
  const Rows y = states(problem, times);
  require_shape(id, y, problem.size(), times.size());
  for (int n = is_two_sided(problem) ? 0 : 1; n <= grid.steps; ++n)
    if (!run.accept(grid.time(n), y.col(n))) break;
  return run.finish();
}

}  // namespace

OwnScheme::OwnScheme(std::string id, StatesOfRun states, const Capabilities& capabilities)
    : id_(std::move(id)),
      scheme_{.id = id_,
              .title = id_,
              .source = "the caller",
              .capabilities = capabilities,
              .solve = with_conditions(
                  on_grid([this, states = std::move(states)](const Problem& problem, const Grid& grid,
                                                             const Options& options) {
                    return run_of(id_, states, problem, grid, options);
                  }))} {}

void require_own_ids(const std::vector<const Scheme*>& own) {
  std::set<std::string_view> ids;
  for (const Scheme* scheme : own) {
    if (find_scheme(scheme->id) != nullptr || !is_printable(scheme->id) || !ids.insert(scheme->id).second)
      reject_text("schemes", scheme->id, "an id that prints and that no other scheme has");
  }
}

}  // namespace fde::bench
