#pragma once

#include "checkpoint/archive.hpp"

namespace fde {

// Who keeps the state of a run between two steps, so that it can go on after a kill. What a continued run
// returns has the bits of one that was never ended: the same problem, resolution, options (but threads and
// budget) and program. One object a run.
class Checkpoints {
 public:
  Checkpoints() = default;
  Checkpoints(const Checkpoints&) = delete;
  Checkpoints& operator=(const Checkpoints&) = delete;
  virtual ~Checkpoints() = default;

  // Before the first step: brings the run to a state that was kept. False: there is none, it begins.
  virtual bool resume(const State& state) = 0;

  // Between two steps: may keep the state.
  virtual void offer(const State& state) = 0;
};

}  // namespace fde
