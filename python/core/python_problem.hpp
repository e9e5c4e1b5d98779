// SPDX-License-Identifier: MIT
#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <memory>
#include <string>
#include <vector>

#include "fdebench/benchmarks/measures/own_measure.hpp"
#include "fdebench/benchmarks/requests/own_scheme.hpp"
#include "fdebench/benchmarks/scenes/scene.hpp"

namespace fde::bench::python {

// The scene of a problem with the values `initial` of y_i(0), and of y_i'(0) for an order above 1, the names
// of the unknowns, and times `jumps` at which the right-hand side is discontinuous. Its right-hand side
// rhs(t, y) and Jacobian jacobian(t, y) (or None) are Python functions of NumPy arrays, with results of shape
// (n,) and (n, n). With `delays` they have a third argument, y(t - delays[k]) in row k of an array, and
// before(t) is y(t) for t < 0. The C++ functions acquire the interpreter lock themselves. Throws as own_scene
// does. Exceptions of a Python function propagate as error_already_set; a result of another shape raises
// ValueError.
Scene python_scene(const std::vector<double>& orders, const std::vector<std::vector<double>>& initial,
                   const pybind11::object& rhs, double end, const pybind11::object& jacobian,
                   const std::vector<std::string>& names, const std::vector<double>& jumps,
                   const std::vector<double>& delays, const pybind11::object& before);

// A scheme states(problem, times) -> array of shape (len(times), n), a Python function; it propagates
// exceptions as the right-hand side does.
std::unique_ptr<OwnScheme> python_scheme(const std::string& id, const pybind11::object& states);

// A measure value(times, values, reference) -> number or None, a Python function of arrays with one row a
// time; the reference is None where there is none.
OwnMeasure python_measure(const std::string& id, const pybind11::object& value);

// One row of the array for each column of the matrix; an array of one dimension for a vector.
pybind11::array_t<double> array_of(const Rows& values);
pybind11::array_t<double> array_of(In y);

// The class of `problem` there: orders, initial, end, rhs(t, y).
void define_posed_problem(pybind11::module_& module);

}  // namespace fde::bench::python
