#pragma once

#include <pybind11/pybind11.h>

#include <string>
#include <vector>

#include "scenes/registry.hpp"
#include "scenes/scene.hpp"

namespace fde::python {

// What Python says of a problem, besides its functions.
struct ProblemFacts {
  std::vector<double> orders;
  std::vector<std::vector<double>> initial;
  double end;
  std::vector<std::string> names;  // of the unknowns
  std::vector<double> jumps;
};

// A problem whose right-hand side, and Jacobian unless that is None, are functions of Python:
// rhs(t, y) and jacobian(t, y), y and what they return as NumPy arrays. Schemes call them without the
// interpreter's lock, which they take. Its reference is computed when first asked for, and kept.
Scene python_scene(const ProblemFacts& facts, const pybind11::object& rhs, const pybind11::object& jacobian);

// The scenes that there are and this one under the id "problem".
Scenes with_problem(const Scene& scene);

}  // namespace fde::python
