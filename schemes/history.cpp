#include "history.hpp"

#include "history_direct.hpp"

namespace fde {

HistoryKind resolve(HistoryKind kind, int /*steps*/) {
  return kind == HistoryKind::automatic ? HistoryKind::direct : kind;
}

std::string_view name(HistoryKind kind) { return kind == HistoryKind::direct ? "direct" : "auto"; }

std::unique_ptr<History> make_history(HistoryKind /*kind*/, const WeightTables& tables, int steps) {
  return std::make_unique<DirectHistory>(tables, steps);
}

}  // namespace fde
