// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "fdebench/schemes/stepping/checkpoints.hpp"

namespace fde::bench {

// Ends a run.
struct RunInterrupted : std::exception {};

// Stores the n-th offered state in memory and ends the run there by throwing Interrupted; n = 0: never. kept:
// a state to resume from; empty: none.
class InterruptingCheckpoints final : public CheckpointStore {
 public:
  explicit InterruptingCheckpoints(int n, std::string saved_state = {})
      : left_(n), saved_state_(std::move(saved_state)) {}

  bool resume(const fde::StateArchiver& state) override {
    if (saved_state_.empty()) return false;
    std::size_t next = 0;
    ReadingArchive archive(
        [&](char* bytes, std::size_t count) { next += saved_state_.copy(bytes, count, next); },
        saved_state_.size());
    state(archive);
    archive.end();
    return true;
  }

  void offer(const fde::StateArchiver& state) override {
    if (--left_ != 0) return;
    saved_state_.clear();
    WritingArchive archive([&](std::string_view bytes) { saved_state_ += bytes; });
    state(archive);
    throw RunInterrupted();
  }

  // The stored state; empty if the run ended before.
  [[nodiscard]] const std::string& saved_state() const { return saved_state_; }

 private:
  int left_;
  std::string saved_state_;
};

}  // namespace fde::bench
