#pragma once

#include <pybind11/pybind11.h>

#include <chrono>
#include <cstddef>

#include "progress/work.hpp"

namespace fde::python {

// Hears of work, and every twentieth of a second lets Python handle its signals. Throws what the handler of
// one raised: KeyboardInterrupt for Ctrl-C.
class Signals {
 public:
  void operator()(std::size_t done, std::size_t total);

 private:
  std::chrono::steady_clock::time_point looked_ = std::chrono::steady_clock::now();
};

// Does work of ours while other threads of Python run; signals end it wherever it says how far it is.
template <typename Work>
auto released(const Work& work) {
  const pybind11::gil_scoped_release other_threads_run;
  const ListeningToWork listening{Signals()};
  return work();
}

}  // namespace fde::python
