// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "fdebench/benchmarks/observers/retained_columns.hpp"
#include "fdebench/benchmarks/requests/requested_run.hpp"
#include "fdebench/benchmarks/requests/solve_cost.hpp"
#include "fdebench/schemes/stepping/checkpoints.hpp"

namespace fde::bench {

// What identifies a run, as names and values: runs with equal facts have the same bits.
using RunFacts = std::vector<std::pair<std::string, std::string>>;

// The state of a run in a file: a line of JSON with the facts of the run, the bytes of the state, and the
// SHA-256 of all of that. The file is replaced atomically.
class CheckpointFile final : public CheckpointStore {
 public:
  // Writes the state, and the state of `observers`, when `between` seconds have passed since the last write.
  // If a write fails, the run goes on and `say` is called once. Throws std::invalid_argument naming the path
  // if the file cannot be written, is no checkpoint, is damaged, or is of another run (the message names the
  // difference).
  CheckpointFile(std::filesystem::path path, std::chrono::duration<double> between, RunFacts facts,
                 fde::StateArchiver observers, std::function<void(const std::string&)> say);

  // Throws std::invalid_argument naming the path if the file contains no state of this run.
  bool resume(const fde::StateArchiver& state) override;
  void offer(const fde::StateArchiver& state) override;

  // Of the states written since the start.
  [[nodiscard]] CheckpointCost cost() const { return spent_; }

  // Removes the file. To be called when the run has ended.
  void remove() const;

 private:
  using Clock = std::chrono::steady_clock;
  void check() const;
  void compare(const std::string& header) const;
  void write(const fde::StateArchiver& state);

  std::filesystem::path path_;
  std::chrono::duration<double> between_;
  RunFacts facts_;
  fde::StateArchiver observers_;
  std::function<void(const std::string&)> say_;
  Clock::time_point written_ = Clock::now();
  bool failed_ = false;
  CheckpointCost spent_{};
};

// The file that a request keeps its run in, with the columns `kept` as part of the state; nullopt without
// one. `say` is called with a message if the file cannot be written. The file is valid for runs with the same
// scene, scheme, resolution, history, tolerance and times by the same build. Throws Refusal where the scheme
// has no checkpoints, and std::invalid_argument naming the path as CheckpointFile does.
std::optional<CheckpointFile> requested_checkpoint(const Scene& scene, const SolveRequest& request,
                                                   const RequestedRun& run, RetainedColumns& kept,
                                                   const std::function<void(const std::string&)>& say);

}  // namespace fde::bench
