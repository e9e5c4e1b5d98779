// SPDX-License-Identifier: MIT
#include "fdebench/reports/command/cost_text.hpp"

#include <nlohmann/json.hpp>

#include "fdebench/schemes/stepping/rates.hpp"

namespace fde::bench {

std::string cost_text(const Scene& scene, const RequestedRun& run, const Cost& cost, double seconds,
                      const CheckpointFile* checkpoints) {
  nlohmann::ordered_json shown{{"seconds", seconds}};
  const auto add = [&shown](const char* key, const auto& count) {
    if (count) shown[key] = *count;
  };
  add("rhs", cost.rhs_calls);
  add("newton", cost.newton_iterations);
  if (!run.automatic_grid.empty()) shown["grid"] = run.automatic_grid;
  if (run.grid && !cost.history.empty()) shown["history"] = cost.history;
  add("history_bytes", cost.history_bytes);
  add("states", cost.components);
  if (!cost.linear_solver.empty()) shown["linear_solver"] = cost.linear_solver;
  add("start_weights", cost.starting_weights);
  add("rejected_steps", cost.rejected_steps);
  if (checkpoints != nullptr) {
    const auto& write_cost = checkpoints->write_cost();
    shown["continued"] = checkpoints->resumed();
    shown["checkpoints"] = write_cost.count;
    shown["checkpoint_bytes"] = write_cost.bytes;
    shown["checkpoint_seconds"] = write_cost.seconds;
  }
  if (run.grid)
    add("expected_rate", theoretical_rate(run.scheme, scene.problem, scene.smoothness, *run.grid, Norm::end));
  return shown.dump();
}

}  // namespace fde::bench
