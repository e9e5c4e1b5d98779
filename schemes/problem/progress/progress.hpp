// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <exception>
#include <functional>

// Progress reports of solves and long evaluations, and their cancellation.
namespace fde {

// Called after steps of the work: `done` steps of `total`, 0 where the total is unknown.
using ProgressCallback = std::function<void(std::size_t done, std::size_t total)>;

// Thrown by a callback to cancel the work. Evaluations pass it on and do not treat it as a numerical failure.
struct Cancelled : std::exception {
  [[nodiscard]] const char* what() const noexcept override { return "the work was ended"; }
};

// While this object exists, `callback` is called for the work of this thread, in addition to the callbacks of
// enclosing objects. Objects of a thread must be destroyed in reverse order of construction.
class ProgressScope {
 public:
  explicit ProgressScope(ProgressCallback callback);
  ~ProgressScope();
  ProgressScope& operator=(ProgressScope&&) = delete;

 private:
  friend void report_progress(std::size_t done, std::size_t total);
  ProgressCallback callback_;
  ProgressScope* outer_;
};

// Reports progress to all callbacks of this thread. Propagates exceptions of callbacks.
void report_progress(std::size_t done, std::size_t total = 0);

}  // namespace fde
