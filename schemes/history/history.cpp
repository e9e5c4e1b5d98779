#include "history/history.hpp"

#include <algorithm>
#include <cstdlib>

#include "history/direct.hpp"
#include "history/exponentials.hpp"
#include "history/graded_direct.hpp"
#include "history/graded_exponentials.hpp"

namespace fde {
namespace {

// Rounding, and where a sum of exponentials still deserves the name.
constexpr double finest_tolerance = 1e-16, coarsest_tolerance = 0.1;

}  // namespace

HistoryKind resolve(HistoryKind kind, const Grid& grid) {
  // Measured by fde_histories; on other grids every weight of the direct engine costs a power.
  const int break_even = grid.uniform() ? 128 : 16;
  if (kind != HistoryKind::automatic) return kind;
  return grid.steps < break_even ? HistoryKind::direct : HistoryKind::exponentials;
}

std::string_view name(HistoryKind kind) {
  switch (kind) {
    case HistoryKind::automatic:
      return "auto";
    case HistoryKind::direct:
      return "direct";
    case HistoryKind::exponentials:
      return "exponentials";
  }
  std::abort();
}

std::unique_ptr<History> make_history(HistoryKind kind, const WeightTables& tables, const Grid& grid,
                                      double tolerance) {
  const bool direct = resolve(kind, grid) == HistoryKind::direct;
  const double achievable = std::clamp(tolerance, finest_tolerance, coarsest_tolerance);
  if (grid.uniform()) {
    if (direct) return std::make_unique<DirectHistory>(tables, grid.steps);
    return std::make_unique<ExponentialHistory>(tables, grid.steps, achievable);
  }
  if (direct) return std::make_unique<GradedDirectHistory>(tables, grid);
  return std::make_unique<GradedExponentialHistory>(tables, grid, achievable);
}

}  // namespace fde
