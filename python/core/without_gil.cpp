// SPDX-License-Identifier: MIT
#include "fdebench/python/core/without_gil.hpp"

namespace fde::bench::python {

void SignalCheck::operator()(std::size_t /*done*/, std::size_t /*total*/) {
  using namespace std::chrono_literals;
  const auto now = std::chrono::steady_clock::now();
  if (now - looked_ < 50ms) return;
  looked_ = now;
  const pybind11::gil_scoped_acquire lock;
  if (PyErr_CheckSignals() != 0) throw pybind11::error_already_set();
}

}  // namespace fde::bench::python
