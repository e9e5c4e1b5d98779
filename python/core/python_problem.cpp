// SPDX-License-Identifier: MIT
#include "fdebench/python/core/python_problem.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <functional>
#include <memory>
#include <string>

#include "fdebench/benchmarks/requests/own_problem.hpp"

namespace py = pybind11;

namespace fde::bench::python {
namespace {

// A Python object that may be copied and destroyed without holding the interpreter lock.
using SharedObject = std::shared_ptr<const py::object>;
SharedObject shared(const py::object& object) {
  return {new py::object(object), [](const py::object* held) {
            const py::gil_scoped_acquire lock;
            delete held;
          }};
}

[[noreturn]] void throw_value_error(const std::string& message) {
  PyErr_SetString(PyExc_ValueError, message.c_str());
  throw py::error_already_set();
}

// What NumPy would convert to doubles although it is no real numbers: None to nan, a complex number to its
// real part, text to the number that it spells. nullptr: nothing.
const char* no_reals(const py::array& any) {
  switch (any.dtype().kind()) {
    case 'b':
    case 'i':
    case 'u':
    case 'f':
      return nullptr;
    case 'c':
      return "complex numbers";
    case 'U':
    case 'S':
      return "text";
    case 'O':
      for (const py::handle one : any.attr("flat")) {
        if (one.is_none()) return "None";
        if (py::isinstance<py::str>(one) || py::isinstance<py::bytes>(one)) return "text";
        if (PyComplex_Check(one.ptr())) return "complex numbers";
      }
      return nullptr;
    default:
      return "no numbers";
  }
}

// The result of function(t, y) as an array. Throws error_already_set with the exception that the function
// raises, or with ValueError for no real numbers or a wrong shape; never std::runtime_error, which means a
// failure of the solve.
using Numbers = py::array_t<double, py::array::c_style | py::array::forcecast>;
Numbers reals_of(const py::object& result, const std::string& name, const std::string& place,
                 const std::vector<py::ssize_t>& shape) {
  const auto any = py::array::ensure(result);
  if (!any) throw py::error_already_set();
  if (const auto* given = no_reals(any))
    throw_value_error(fmt::format("{}: returned {}{}, must be real numbers", name, given, place));
  auto numbers = Numbers::ensure(any);
  if (!numbers) throw py::error_already_set();
  const std::vector<py::ssize_t> given(numbers.shape(), numbers.shape() + numbers.ndim());
  const bool one_number = numbers.ndim() == 0 && shape == std::vector<py::ssize_t>{1};
  if (given != shape && !one_number) {
    throw_value_error(fmt::format("{}: returned an array of shape ({}), must be ({})", name,
                                  fmt::join(given, ", "), fmt::join(shape, ", ")));
  }
  return numbers;
}

// Writes what function(t, arrays...) returns, numbers of this shape, to `result`.
void call(const SharedObject& function, const char* name, double t, const std::vector<py::ssize_t>& shape,
          auto result, const auto&... arrays) {
  using ByRows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  const py::gil_scoped_acquire lock;
  const py::object returned = (*function)(t, array_of(arrays)...);
  const Numbers numbers = reals_of(returned, name, fmt::format(" at t = {:.6g}", t), shape);
  result = Eigen::Map<const ByRows>(numbers.data(), result.rows(), result.cols());
}

std::function<void(double, In, Out)> rhs_of(const py::object& function) {
  return [function = shared(function)](double t, In y, Out f) { call(function, "rhs", t, {y.size()}, f, y); };
}

DenseJacobian jacobian_of(const py::object& function) {
  return {[function = shared(function)](double t, In y, OutMatrix jacobian) {
    call(function, "jacobian", t, {y.size(), y.size()}, jacobian, y);
  }};
}

// The functions get y(t - lags[k]) in row k of an array.
Delays delays_of(const std::vector<double>& lags, const py::object& before, const py::object& rhs,
                 const py::object& jacobian) {
  DelayedJacobian slopes;
  if (!jacobian.is_none()) {
    slopes = [function = shared(jacobian)](double t, In y, const Matrix& past, OutMatrix values) {
      call(function, "jacobian", t, {y.size(), y.size()}, values, y, past);
    };
  }
  return own_delays(
      lags, [function = shared(before)](double t, Out y) { call(function, "before", t, {y.size()}, y); },
      [function = shared(rhs)](double t, In y, const Matrix& past, Out f) {
        call(function, "rhs", t, {y.size()}, f, y, past);
      },
      slopes);
}

}  // namespace

Scene python_scene(const std::vector<double>& orders, const std::vector<std::vector<double>>& initial,
                   const py::object& rhs, double end, const py::object& jacobian,
                   const std::vector<std::string>& names, const std::vector<double>& jumps,
                   const std::vector<double>& delays, const py::object& before) {
  Problem problem;
  for (std::size_t i = 0; i < orders.size(); ++i)
    problem.components.push_back({.order = orders[i], .initial = initial[i]});
  if (delays.empty()) {
    problem.rhs = rhs_of(rhs);
    if (!jacobian.is_none()) problem.derivatives = jacobian_of(jacobian);
  } else {
    problem.delays = delays_of(delays, before, rhs, jacobian);
  }
  problem.end = end;
  problem.jump_times = jumps;
  return own_scene(problem, names);
}

std::unique_ptr<OwnScheme> python_scheme(const std::string& id, const py::object& states) {
  return std::make_unique<OwnScheme>(
      id, [id, function = shared(states)](const Problem& problem, const std::vector<double>& times) -> Rows {
        const py::gil_scoped_acquire lock;
        const auto count = static_cast<py::ssize_t>(times.size());
        const py::object result =
            (*function)(std::make_shared<Problem>(problem), py::array_t<double>(count, times.data()));
        const Numbers numbers = reals_of(result, "scheme " + id, "", {count, problem.size()});
        return Eigen::Map<const Rows>(numbers.data(), problem.size(),
                                      count);  // by columns: row after row of the array
      });
}

py::array_t<double> array_of(const Rows& values) {
  return py::array_t<double>({values.cols(), values.rows()}, values.data());
}

py::array_t<double> array_of(In y) { return py::array_t<double>(y.size(), y.data()); }

OwnMeasure python_measure(const std::string& id, const py::object& value) {
  return {id,
          [id, function = shared(value)](const std::vector<double>& times, const Rows& values,
                                         const Rows& reference) -> std::optional<double> {
            const py::gil_scoped_acquire lock;
            const py::object known = reference.cols() > 0 ? py::object(array_of(reference)) : py::none();
            const py::array_t<double> at(std::ssize(times), times.data());
            const py::object result = (*function)(at, array_of(values), known);
            if (result.is_none()) return std::nullopt;
            return *reals_of(result, "measure " + id, "", {1}).data();
          }};
}

void define_posed_problem(py::module_& module) {
  const auto orders = [](const Problem& problem) {
    std::vector<double> all;
    for (const auto& component : problem.components) all.push_back(component.order);
    return all;
  };
  const auto initial = [](const Problem& problem) {
    std::vector<std::vector<double>> all;
    for (const auto& component : problem.components) all.push_back(component.initial);
    return all;
  };
  const auto rhs = [](const Problem& problem, double t, const Numbers& y) {
    if (y.size() != problem.size())
      throw_value_error(fmt::format("y: has {} entries, must have {}", y.size(), problem.size()));
    if (!problem.delays.lags.empty())
      throw_value_error("rhs: the problem has delays, its right-hand side is no function of t and y");
    Numbers f(problem.size());
    problem.rhs(t, Eigen::Map<const Vec>(y.data(), y.size()), Eigen::Map<Vec>(f.mutable_data(), f.size()));
    return f;
  };
  py::class_<Problem, std::shared_ptr<Problem>>(module, "PosedProblem")
      .def_property_readonly("orders", orders)
      .def_property_readonly("initial", initial)
      .def_readonly("end", &Problem::end)
      .def("rhs", rhs);
}

}  // namespace fde::bench::python
