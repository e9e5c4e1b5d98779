// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/requests/solve_cost.hpp"

#include <nlohmann/json.hpp>
#include <string_view>

namespace fde::bench {

nlohmann::ordered_json json_of(const SolveCost& cost) {
  nlohmann::ordered_json shown{{"seconds", cost.seconds}};
  const auto add = [&shown](const char* key, const auto& count) {
    if (count) shown[key] = *count;
  };
  const auto add_text = [&shown](const char* key, std::string_view text) {
    if (!text.empty()) shown[key] = std::string(text);
  };
  const Cost& of_scheme = cost.of_scheme;
  add("rhs", of_scheme.rhs_calls);
  add("newton", of_scheme.newton_iterations);
  add_text("grid", cost.grid);
  add_text("history", of_scheme.history);
  add("history_bytes", of_scheme.history_bytes);
  add("states", of_scheme.components);
  add_text("linear_solver", of_scheme.linear_solver);
  add("start_weights", of_scheme.starting_weights);
  add("rejected_steps", of_scheme.rejected_steps);
  if (cost.checkpoints) {
    shown["continued"] = cost.checkpoints->continued;
    shown["checkpoints"] = cost.checkpoints->count;
    shown["checkpoint_bytes"] = cost.checkpoints->bytes;
    shown["checkpoint_seconds"] = cost.checkpoints->seconds;
  }
  add("expected_rate", cost.expected_rate);
  return shown;
}

}  // namespace fde::bench
