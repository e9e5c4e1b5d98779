#include "history.hpp"

#include "history_direct.hpp"
#include "history_exponentials.hpp"
#include "history_graded.hpp"

namespace fde {

HistoryKind resolve(HistoryKind kind, const Grid& grid) {
  constexpr int break_even = 256;
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
  if (grid.uniform()) {
    if (direct) return std::make_unique<DirectHistory>(tables, grid.steps);
    return std::make_unique<ExponentialHistory>(tables, grid.steps, tolerance);
  }
  if (direct) return std::make_unique<GradedDirectHistory>(tables, grid);
  return std::make_unique<GradedExponentialHistory>(tables, grid, tolerance);
}

}  // namespace fde
