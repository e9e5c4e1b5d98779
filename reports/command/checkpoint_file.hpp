#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "checkpoint/checkpoints.hpp"

namespace fde {

// What a run is, as names and values: runs that agree in all of them have the same bits.
using RunFacts = std::vector<std::pair<std::string, std::string>>;

// The state of a run in a file. Its first line is JSON with the facts of the run; then come the bytes of the
// state and the SHA-256 of all of it. It appears whole, in place of the one before.
class CheckpointFile final : public Checkpoints {
 public:
  // Writes the state when so many seconds have passed since the last one, with what observers have kept of
  // the run. A file that cannot be written does not end the run: `say` hears of it once.
  // Throws std::invalid_argument naming the path where nothing can be written there, or where there is
  // something that is no checkpoint, is damaged, or is of another run: with what differs.
  CheckpointFile(std::filesystem::path path, std::chrono::duration<double> between, RunFacts facts,
                 State observers, std::function<void(const std::string&)> say);

  // Throws std::invalid_argument naming the path where the file holds no state of the run.
  bool resume(const State& state) override;
  void offer(const State& state) override;

  // Whether the run goes on from a state that was there.
  [[nodiscard]] bool resumed() const { return resumed_; }

  // What the states written since the start have cost.
  struct Spent {
    std::int64_t count = 0;
    std::uintmax_t bytes = 0;  // of the last
    double seconds = 0.0;      // of all
  };
  [[nodiscard]] const Spent& spent() const { return spent_; }

  // The run has ended.
  void remove() const;

 private:
  using Clock = std::chrono::steady_clock;
  void check() const;
  void compare(const std::string& header) const;
  void write(const State& state);

  std::filesystem::path path_;
  std::chrono::duration<double> between_;
  RunFacts facts_;
  State observers_;
  std::function<void(const std::string&)> say_;
  Clock::time_point written_ = Clock::now();
  bool failed_ = false, resumed_ = false;
  Spent spent_;
};

}  // namespace fde
