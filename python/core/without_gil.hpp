// SPDX-License-Identifier: MIT
#pragma once

#include <pybind11/pybind11.h>

#include <chrono>
#include <cstddef>

#include "fdebench/schemes/problem/progress/progress.hpp"

namespace fde::bench::python {

// Progress callback that lets Python handle its signals, at most every 50 ms. Throws the exception of the
// signal handler: KeyboardInterrupt for Ctrl-C.
class SignalCheck {
 public:
  void operator()(std::size_t done, std::size_t total);

 private:
  std::chrono::steady_clock::time_point looked_ = std::chrono::steady_clock::now();
};

// Runs `work` without the interpreter lock, so that other Python threads run. Signals cancel it where it
// reports progress.
template <typename Work>
auto without_gil(const Work& work) {
  const pybind11::gil_scoped_release other_threads_run;
  const ProgressScope scope{SignalCheck()};
  return work();
}

}  // namespace fde::bench::python
