// SPDX-License-Identifier: MIT
#pragma once

#include "fdebench/schemes/problem/archive.hpp"

namespace fde {

// Stores the state of a run between two steps, so that it can be resumed after a kill. The result of a
// resumed run has the same bits as an uninterrupted run. Precondition: problem, resolution, options (except
// threads and budget) and program are the same. One object a run.
class CheckpointStore {
 public:
  CheckpointStore& operator=(CheckpointStore&&) = delete;
  virtual ~CheckpointStore() = default;

  // Called before the first step: restores a stored state. False where there is none.
  virtual bool resume(const StateArchiver& state) = 0;

  // Called between two steps: may store the state.
  virtual void offer(const StateArchiver& state) = 0;
};

}  // namespace fde
