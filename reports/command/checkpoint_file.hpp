// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "fdebench/benchmarks/observers/retained_columns.hpp"
#include "fdebench/reports/command/requested_run.hpp"
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

  // Whether the run continues from a stored state.
  [[nodiscard]] bool resumed() const { return resumed_; }

  // The cost of the states written since the start.
  struct WriteCost {
    std::int64_t count = 0;
    std::uintmax_t bytes = 0;  // of the last state
    double seconds = 0.0;      // of all writes
  };
  [[nodiscard]] const WriteCost& write_cost() const { return spent_; }

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
  bool failed_ = false, resumed_ = false;
  WriteCost spent_;
};

// The file of --checkpoint, with the columns `kept` as part of the state; nullopt without --checkpoint. `say`
// is called with a message if the file cannot be written. The file is valid for runs with the same scene,
// scheme, resolution, history, tolerance and times by the same build. Throws std::invalid_argument naming the
// argument, the text and what is allowed.
std::optional<CheckpointFile> requested_checkpoint(const Scene& scene, const RequestedRun& run,
                                                   const Given& given, RetainedColumns& kept,
                                                   const std::function<void(const std::string&)>& say);

}  // namespace fde::bench
