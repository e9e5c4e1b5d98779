// SPDX-License-Identifier: MIT
#include <pybind11/complex.h>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <complex>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <string>
#include <system_error>
#include <tuple>
#include <utility>
#include <vector>

#include "fdebench/benchmarks/equation_files/equation_scene.hpp"
#include "fdebench/benchmarks/records/record.hpp"
#include "fdebench/benchmarks/records/record_text.hpp"
#include "fdebench/benchmarks/requests/answers_json.hpp"
#include "fdebench/benchmarks/requests/choice.hpp"
#include "fdebench/benchmarks/requests/exact.hpp"
#include "fdebench/benchmarks/requests/fit.hpp"
#include "fdebench/benchmarks/requests/own_problem.hpp"
#include "fdebench/benchmarks/requests/recorded_sweep.hpp"
#include "fdebench/benchmarks/requests/solve.hpp"
#include "fdebench/benchmarks/scenes/start_time.hpp"
#include "fdebench/benchmarks/scenes/variant.hpp"
#include "fdebench/benchmarks/text/printable.hpp"
#include "fdebench/benchmarks/text/refusal.hpp"
#include "fdebench/python/core/python_problem.hpp"
#include "fdebench/python/core/without_gil.hpp"
#include "fdebench/python/program/run_program.hpp"
#include "fdebench/reference/special_functions/mittag_leffler/mittag_leffler.hpp"

// The extension module of the package `fdebench`. The public functions with their docstrings are in
// ../fdebench.
namespace py = pybind11;

namespace fde::bench::python {
namespace {

// Equation files are read at every call, as they may have changed.
SceneRegistry named_scenes(NoteReceiver on_note = {}) {
  return with_equation_files(built_in_scenes(), std::move(on_note));
}

// Tuple of id, column names, orders, end time, and what the scene changes of its file ("" if nothing).
py::tuple facts(const std::string& name, const std::vector<std::string>& settings) {
  std::string changes;
  const auto [id, scene] = without_gil([&]() -> std::pair<std::string, Scene> {
    const SceneRegistry all = named_scenes([&](const std::string& note) { changes = note; });
    const auto variant = read_variant(name, settings, all);
    return {variant.factory->id, make_scene_unchecked(variant)};
  });
  std::vector<double> orders;
  for (const auto& component : scene.problem.components) orders.push_back(component.order);
  return py::make_tuple(id, scene.outputs.names, orders, end_time(scene), changes);
}

// The scene with its settings NAME=VALUE, made by `make`, or a problem defined in Python (if not nullptr).
Scene scene_of(const std::string& name, const std::vector<std::string>& settings, const Scene* problem,
               Scene (*make)(const SceneVariant&)) {
  if (problem != nullptr) return *problem;
  const SceneRegistry all = named_scenes();
  return make(read_variant(name, settings, all));
}

// The value with the types of Python.
template <typename Json>
py::object object_of(const Json& value) {
  if (value.is_null()) return py::none();
  if (value.is_boolean()) return py::bool_(value.template get<bool>());
  if (value.is_number_integer()) return py::int_(value.template get<std::int64_t>());
  if (value.is_number()) return py::float_(value.template get<double>());
  if (value.is_string()) return py::str(value.template get<std::string>());
  if (value.is_array()) {
    py::list list;
    for (const auto& one : value) list.append(object_of(one));
    return list;
  }
  py::dict dictionary;
  for (const auto& [key, one] : value.items()) dictionary[py::str(key)] = object_of(one);
  return dictionary;
}

template <typename Value>
std::optional<Value> find(const py::dict& given, const char* name) {
  return given.contains(name) ? std::optional(given[name].cast<Value>()) : std::nullopt;
}

// The arguments of fdebench.solve that are given, by their names.
SolveRequest request_of(const std::string& scheme, const py::dict& given) {
  SolveRequest request{.scheme = scheme};
  request.settings.resolution = resolution_from(find<int>(given, "steps"), find<double>(given, "accuracy"));
  set_grid(request, given["grid"].cast<std::string>());
  request.settings.history = parse_history(given["history"].cast<std::string>());
  request.settings.budget = given["budget"].cast<double>();
  if (const auto tolerance = find<double>(given, "tolerance")) request.settings.newton_tolerance = *tolerance;
  request.times = output_times_from(find<std::vector<double>>(given, "at"), find<int>(given, "every"),
                                    find<int>(given, "points"));
  request.check = given["check"].cast<bool>();
  request.events = given["events"].cast<bool>();
  return request;
}

// Tuple of names, times, values (one row a time), warning, cost, and the names of events or None. Of a scene
// with its settings NAME=VALUE, or of a problem defined in Python (if not nullptr).
py::tuple solve_for(const std::string& name, const std::vector<std::string>& settings, const Scene* problem,
                    const std::string& scheme, const py::dict& given) {
  const auto request = request_of(scheme, given);
  const SolvedTable table =
      without_gil([&] { return solve(scene_of(name, settings, problem, make_scene), request); });
  const py::array_t<double> times(std::ssize(table.times), table.times.data());
  return py::make_tuple(table.names, times, array_of(table.values), warning_text(table.warnings),
                        object_of(json_of(table.cost)), table.events);
}

// Tuple of names, values and bounds, one row a time.
py::tuple exact_of(const std::string& name, const std::vector<std::string>& settings, const Scene* problem,
                   const std::vector<double>& times) {
  const auto table =
      without_gil([&] { return exact(scene_of(name, settings, problem, make_scene_unchecked), times); });
  return py::make_tuple(table.names, array_of(table.values), array_of(table.bounds));
}

// The same as lists of decimal texts.
py::tuple exact_decimals(const std::string& name, const std::vector<std::string>& settings,
                         const Scene* problem, const std::vector<double>& times, int digits) {
  std::vector<std::vector<std::string>> values, bounds;
  const auto names = without_gil([&] {
    const Scene scene = scene_of(name, settings, problem, make_scene_unchecked);
    for (const auto& row : exact_in_digits(scene, problem == nullptr ? name : own_id, times, digits)) {
      auto &of_values = values.emplace_back(), &of_bounds = bounds.emplace_back();
      for (const auto& [value, bound] : row) {
        of_values.push_back(value);
        of_bounds.push_back(bound);
      }
    }
    return scene.outputs.names;
  });
  return py::make_tuple(names, values, bounds);
}

// Dictionaries, one an entry.
template <typename Entries>
py::list facts_of_all(const Entries& entries) {
  const auto all = without_gil([&] {
    auto facts = nlohmann::ordered_json::array();
    for (const auto& entry : entries) facts.push_back(json_of(entry));
    return facts;
  });
  return object_of(all);
}

// Functions of Python by the ids of schemes and of measures; see python_scheme and python_measure.
using Functions = std::map<std::string, py::object>;

std::vector<OwnMeasure> measures_of(const Functions& functions) {
  std::vector<OwnMeasure> measures;
  for (const auto& [id, value] : functions) measures.push_back(python_measure(id, value));
  return measures;
}

// The refusal of a sweep with the arguments of Python for its fields.
Refusal said_of_sweep(const Refusal& refusal) {
  return refusal.said([](const std::string& field) {
    return field == "scheme" ? "schemes" : field == "accuracy" ? "accuracies" : field;
  });
}

// Tuple of the runs of a sweep, a dictionary each, as a line of a results file has them, and a warning of
// other lines of the file. `scenes`: names with their settings NAME=VALUE. `schemes`: None for a scheme of
// ours. `results`: the file; None: there is none.
py::tuple sweep_for(const std::vector<std::pair<std::string, std::vector<std::string>>>& scenes,
                    const py::dict& schemes, const Functions& measures, const std::vector<int>& steps,
                    const std::vector<double>& accuracies, const py::dict& given,
                    const std::optional<std::string>& results) {
  std::vector<std::unique_ptr<OwnScheme>> own;
  const auto grading = parse_grid(given["grid"].cast<std::string>());
  SweepRequest request{.measures = measures_of(measures),
                       .settings = {.grading = grading.value_or(1.0),
                                    .history = parse_history(given["history"].cast<std::string>())},
                       .optimal_grading = !grading,
                       .budget = find<double>(given, "budget"),
                       .repeats = given["repeat"].cast<int>()};
  if (const auto tolerance = find<double>(given, "tolerance")) request.settings.newton_tolerance = *tolerance;
  for (const auto& [name, states] : schemes) {
    const auto id = name.cast<std::string>();
    if (!states.is_none()) own.push_back(python_scheme(id, py::reinterpret_borrow<py::object>(states)));
    request.schemes.push_back(states.is_none() ? &scheme_named(id) : &own.back()->scheme());
  }
  request.resolutions.assign(steps.begin(), steps.end());
  for (const double one : accuracies) request.resolutions.emplace_back(Tolerance{.rtol = one, .atol = one});
  std::string warning;
  const auto runs = without_gil([&] {
    const SceneRegistry all = named_scenes();
    for (const auto& [name, settings] : scenes) request.scenes.push_back(read_variant(name, settings, all));
    auto lines = nlohmann::json::array();
    const SweepListener listener{.warn = [&](const std::string& text) { warning = text; }};
    try {
      const auto made = results ? sweep(request, *results, listener) : sweep(request);
      for (const Record& run : made) lines.push_back(json_of(run));
    } catch (const Refusal& refusal) {
      throw said_of_sweep(refusal);
    }
    return lines;
  });
  return py::make_tuple(object_of(runs), warning);
}

// Dictionary of what is chosen. `columns`: names with commas between them; None: all.
py::object choose_for(const std::string& name, const std::vector<std::string>& settings, const Scene* problem,
                      double error, const std::string& norm, const std::string& scale,
                      const std::optional<std::string>& columns, double seconds, const std::string& runs,
                      const Functions& schemes, const Functions& measures) {
  std::vector<std::unique_ptr<OwnScheme>> own;
  for (const auto& [id, states] : schemes) own.push_back(python_scheme(id, states));
  ChoiceRequest request{.error = error,
                        .kind = {parse_norm(norm), parse_scale(scale)},
                        .columns = columns ? split_names(*columns) : std::vector<std::string>(),
                        .seconds = seconds,
                        .first_run = parse_first_run(runs),
                        .measures = measures_of(measures)};
  for (const auto& scheme : own) request.schemes.push_back(&scheme->scheme());
  const auto facts = without_gil([&] {
    if (problem != nullptr) return json_of(choose(*problem, request));
    const SceneRegistry all = named_scenes();
    const auto variant = read_variant(name, settings, all);
    return json_of(choose(make_scene(variant), request, variant.key()));
  });
  return object_of(facts);
}

// Dictionary of what is fitted. `rows`: a time, and a number for each name after it. `vary`: names with
// limits.
py::object fit_for(
    const std::string& name, const std::vector<std::string>& settings, const std::vector<std::string>& names,
    const std::vector<std::vector<double>>& rows,
    const std::vector<std::tuple<std::string, std::optional<double>, std::optional<double>>>& vary,
    const std::optional<std::string>& scheme, double confidence, double budget) {
  const auto facts = without_gil([&] {
    const SceneRegistry all = named_scenes();
    FitRequest request{.variant = read_variant(name, settings, all),
                       .vary = {},
                       .data = [&](const Scene& scene) { return measured_trajectory(scene, names, rows); },
                       .scheme = scheme,
                       .confidence = confidence,
                       .budget = budget};
    for (const auto& [parameter, low, high] : vary) request.vary.push_back({parameter, low, high});
    return json_of(fit(request, [](int solves) { report_progress(static_cast<std::size_t>(solves)); }));
  });
  return object_of(facts);
}

// E_{alpha,beta}(z) and error bounds, elementwise. Precondition: the arrays have equal lengths.
using Reals = py::array_t<double, py::array::c_style | py::array::forcecast>;
using Complexes = py::array_t<std::complex<double>, py::array::c_style | py::array::forcecast>;
py::tuple mittag_leffler_of(const Reals& alpha, const Reals& beta, const Complexes& z) {
  Complexes values(z.size());
  Reals bounds(z.size());
  const auto *a = alpha.data(), *b = beta.data();
  const auto* x = z.data();
  auto* value = values.mutable_data();
  auto* bound = bounds.mutable_data();
  const auto count = z.size();
  without_gil([=] {
    for (py::ssize_t i = 0; i < count; ++i) {
      report_progress(static_cast<std::size_t>(i), static_cast<std::size_t>(count));
      const auto result = reference::mittag_leffler(a[i], b[i], x[i]);
      value[i] = result.value;
      bound[i] = result.bound;
    }
  });
  return py::make_tuple(values, bounds);
}

py::tuple mittag_leffler_in_digits(const std::string& alpha, const std::string& beta, const std::string& re,
                                   const std::string& im, int digits) {
  const auto value = without_gil([&] { return reference::mittag_leffler(alpha, beta, re, im, digits); });
  return py::make_tuple(value.re, value.im, value.bound);
}

// Raises fdebench.NumericalFailure with scheme, step and time, or None for each.
void raise_failure(const std::string& message, const py::object& scheme, const py::object& step,
                   const py::object& time) {
  const auto type = py::module_::import("fdebench").attr("NumericalFailure");
  const py::object failure = type(message, scheme, step, time);
  PyErr_SetObject(type.ptr(), failure.ptr());
}

void translate(
    std::exception_ptr thrown) {  // NOLINT(performance-unnecessary-value-param): as pybind11 has it
  try {
    if (thrown) std::rethrow_exception(thrown);
  } catch (const RunFailure& failure) {
    raise_failure(failure.what(), py::str(failure.scheme), py::int_(failure.step), py::cast(failure.time));
  } catch (const std::system_error& error) {  // a file that cannot be read
    PyErr_SetString(PyExc_ValueError, error.what());
  } catch (const std::runtime_error& failure) {
    raise_failure(failure.what(), py::none(), py::none(), py::none());
  } catch (const std::invalid_argument& error) {
    PyErr_SetString(PyExc_ValueError, error.what());
  }
}

}  // namespace
}  // namespace fde::bench::python

PYBIND11_MODULE(_core, module) {
  using namespace fde::bench::python;
  py::register_exception_translator(translate);
  py::class_<fde::bench::Scene>(module, "Problem").def(py::init(&python_scene));
  define_posed_problem(module);
  module.def("version", [] { return fde::bench::this_session().version; });
  module.def("scenes", [] { return facts_of_all(fde::bench::built_in_scenes()); });
  module.def("schemes", [] { return facts_of_all(fde::schemes()); });
  module.def("program", [](const std::vector<std::string>& arguments) {
    return without_gil([&] { return run_program(arguments); });
  });
  module.def("facts", facts);
  module.def("solve", solve_for);
  module.def("choose", choose_for);
  module.def("fit", fit_for);
  module.def("sweep", sweep_for);
  module.def("exact", exact_of);
  module.def("exact_in_digits", exact_decimals);
  module.def("mittag_leffler", mittag_leffler_of);
  module.def("mittag_leffler_in_digits", mittag_leffler_in_digits);
}
