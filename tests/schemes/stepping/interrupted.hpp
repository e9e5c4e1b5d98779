#pragma once

#include <stdexcept>
#include <string>

#include "fdebench/schemes/stepping/checkpoints.hpp"

namespace fde {

// Ends a run.
struct RunInterrupted : std::exception {};

// Stores the n-th offered state in memory and ends the run there by throwing Interrupted; n = 0: never. kept:
// a state to resume from; empty: none.
class InterruptingCheckpoints final : public CheckpointStore {
 public:
  explicit InterruptingCheckpoints(int n, std::string kept = {}) : left_(n), kept_(std::move(kept)) {}

  bool resume(const State& state) override {
    if (kept_.empty()) return false;
    std::size_t next = 0;
    ReadingArchive archive([&](char* bytes, std::size_t count) { next += kept_.copy(bytes, count, next); },
                           kept_.size());
    state(archive);
    archive.end();
    return true;
  }

  void offer(const State& state) override {
    if (--left_ != 0) return;
    kept_.clear();
    WritingArchive archive([&](std::string_view bytes) { kept_ += bytes; });
    state(archive);
    throw RunInterrupted();
  }

  // The stored state; empty if the run ended before.
  [[nodiscard]] const std::string& kept() const { return kept_; }

 private:
  int left_;
  std::string kept_;
};

}  // namespace fde
