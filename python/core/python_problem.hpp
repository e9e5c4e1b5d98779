// SPDX-License-Identifier: MIT
#pragma once

#include <pybind11/pybind11.h>

#include <string>
#include <vector>

#include "fdebench/benchmarks/scenes/scene.hpp"

namespace fde::bench::python {

// The data of a problem given from Python, without its functions.
struct ProblemData {
  std::vector<double> orders;
  std::vector<std::vector<double>> initial;  // y_i(0), and y_i'(0) for an order above 1
  double end;
  std::vector<std::string> names;  // of the unknowns
  std::vector<double> jumps;       // times at which the right-hand side is discontinuous
};

// A scene whose right-hand side rhs(t, y) and Jacobian jacobian(t, y) (or None) are Python functions of NumPy
// arrays, with results of shape (n,) and (n, n). The C++ functions acquire the interpreter lock themselves.
// Throws as own_scene does. Exceptions of a Python function propagate as error_already_set; a result of
// another shape raises ValueError.
Scene python_scene(const ProblemData& facts, const pybind11::object& rhs, const pybind11::object& jacobian);

}  // namespace fde::bench::python
