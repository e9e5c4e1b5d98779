// SPDX-License-Identifier: MIT
#include <memory>

#include "fdebench/benchmarks/equation_files/equation_scene.hpp"
#include "fdebench/benchmarks/requests/own_problem.hpp"
#include "fdebench/benchmarks/scenes/start_time.hpp"
#include "fdebench/benchmarks/scenes/variant.hpp"
#include "fdebench/c/guard.hpp"
#include "fdebench/c/handles.hpp"

namespace fde::bench::c {
namespace {

using ByRows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

std::function<void(double, In, Out)> called(fdebench_function f, void* user) {
  return [f, user](double t, In y, Out result) {
    if (const int code = f(t, y.data(), result.data(), user); code != 0) throw CallbackStop("f", t, code);
  };
}

Derivatives derivatives_of(fdebench_function jacobian, void* user) {
  if (jacobian == nullptr) return NoDerivatives{};
  return DenseJacobian{[jacobian, user](double t, In y, OutMatrix result) {
    ByRows by_rows(y.size(), y.size());
    if (const int code = jacobian(t, y.data(), by_rows.data(), user); code != 0)
      throw CallbackStop("jacobian", t, code);
    result = by_rows;
  }};
}

Past called_before(int (*before)(double, double*, void*), void* user) {
  return [before, user](double t, Out y) {
    if (const int code = before(t, y.data(), user); code != 0) throw CallbackStop("before", t, code);
  };
}

DelayedFunction called(fdebench_delayed_function f, void* user) {
  return [f, user](double t, In y, const Matrix& past, Out result) {
    if (const int code = f(t, y.data(), past.data(), result.data(), user); code != 0)
      throw CallbackStop("f", t, code);
  };
}

DelayedJacobian jacobian_of(fdebench_delayed_function jacobian, void* user) {
  if (jacobian == nullptr) return {};
  return [jacobian, user](double t, In y, const Matrix& past, OutMatrix result) {
    ByRows by_rows(y.size(), y.size());
    if (const int code = jacobian(t, y.data(), past.data(), by_rows.data(), user); code != 0)
      throw CallbackStop("jacobian", t, code);
    result = by_rows;
  };
}

// The components; `initial` has their initial values one after the other.
std::vector<Component> components_of(const std::vector<double>& orders, const std::vector<double>& initial) {
  for (const double order : orders) require_order(order);
  std::size_t needed = 0;
  for (const double order : orders) needed += initial_count(order);
  if (initial.size() != needed) {
    throw std::invalid_argument(
        fmt::format("initial_count = {}: must be {}, for each row its order rounded up, 1 for order 0",
                    initial.size(), needed));
  }
  std::vector<Component> rows;
  auto next = initial.begin();
  for (const double order : orders) {
    const auto after = next + static_cast<std::ptrdiff_t>(initial_count(order));
    rows.push_back({.order = order, .initial = {next, after}});
    next = after;
  }
  return rows;
}

// The problem of a handle, to change it. Throws std::invalid_argument if it is a scene's.
FdebenchProblem& own(FdebenchProblem* problem) {
  auto& handle = given("problem", problem, problem_handle);
  if (!handle.scene.empty())
    throw std::invalid_argument(fmt::format("problem = {}: must be of fdebench_problem_new", handle.scene));
  return handle;
}

template <typename Change>
int changed(FdebenchProblem* problem, const Change& change) {
  return guarded([&] {
    auto& handle = own(problem);
    Problem posed = handle.known.problem;
    auto names = handle.known.outputs.names;
    change(handle, posed, names);
    handle.known = own_scene(posed, names);
  });
}

}  // namespace
}  // namespace fde::bench::c

using namespace fde::bench;
using namespace fde::bench::c;

int fdebench_problem_new(size_t unknowns, const double* orders, size_t initial_count, const double* initial,
                         double end, fdebench_function f, void* user, fdebench_problem** problem) {
  return guarded([&] {
    auto& result = given("problem", problem);
    require_count("unknowns", unknowns, 1, most_entries);
    require_count("initial_count", initial_count, 1, 2 * most_entries);
    given("orders", orders, "an order for each unknown");
    given("initial", initial, "the initial values");
    if (f == nullptr) throw std::invalid_argument("f = NULL: must be a function");
    fde::Problem posed{
        .components = components_of({orders, orders + unknowns}, {initial, initial + initial_count}),
        .rhs = called(f, user),
        .end = end};
    auto made = std::make_unique<FdebenchProblem>();
    made->known = own_scene(posed, usual_names(unknowns));
    made->user = user;
    result = made.release();
  });
}

int fdebench_problem_set_jacobian(fdebench_problem* problem, fdebench_function jacobian) {
  return changed(problem, [&](const auto& handle, auto& posed, auto& /*names*/) {
    posed.derivatives = derivatives_of(jacobian, handle.user);
  });
}

int fdebench_problem_set_names(fdebench_problem* problem, size_t count, const char* const* names) {
  return changed(problem, [&](const auto& /*handle*/, auto& /*posed*/, auto& into) {
    given("names", names, "a name for each unknown");
    require_count("count", count, into.size(), into.size());
    for (std::size_t i = 0; i < count; ++i) into[i] = text_of("names", names[i]);
  });
}

int fdebench_problem_set_jumps(fdebench_problem* problem, size_t count, const double* times) {
  return changed(problem, [&](const auto& /*handle*/, auto& posed, auto& /*names*/) {
    require_count("count", count, 0, most_entries);
    posed.jump_times.clear();
    if (count > 0) posed.jump_times.assign(&given("times", times, "the times of the jumps"), times + count);
  });
}

int fdebench_problem_set_delays(fdebench_problem* problem, size_t count, const double* delays,
                                fdebench_delayed_function f, fdebench_delayed_function jacobian,
                                int (*before)(double, double*, void*)) {
  return changed(problem, [&](const auto& handle, auto& posed, auto& /*names*/) {
    require_count("count", count, 1, most_entries);
    given("delays", delays, "the delays");
    if (f == nullptr) throw std::invalid_argument("f = NULL: must be a function");
    if (before == nullptr) throw std::invalid_argument("before = NULL: must be a function");
    posed.delays = own_delays({delays, delays + count}, called_before(before, handle.user),
                              called(f, handle.user), jacobian_of(jacobian, handle.user));
    posed.rhs = {};
    posed.derivatives = fde::NoDerivatives{};
  });
}

int fdebench_problem_of_scene(const char* scene, fdebench_problem** problem) {
  return guarded([&] {
    auto& result = given("problem", problem);
    auto made = std::make_unique<FdebenchProblem>();
    made->scene = text_of("scene", scene);
    const SceneRegistry all = with_equation_files(built_in_scenes());
    made->known = make_scene_unchecked(read_variant(made->scene, {}, all));
    result = made.release();
  });
}

int fdebench_problem_size(const fdebench_problem* problem, size_t* unknowns, size_t* columns) {
  return guarded([&] {
    const auto& scene = given("problem", problem, problem_handle).known;
    auto& size = given("unknowns", unknowns);
    given("columns", columns) = scene.outputs.names.size();
    size = scene.problem.components.size();
  });
}

int fdebench_problem_name(const fdebench_problem* problem, size_t column, const char** name) {
  return guarded([&] {
    const auto& names = given("problem", problem, problem_handle).known.outputs.names;
    auto& result = given("name", name);
    require_index("column", column, names.size());
    result = names[column].c_str();
  });
}

int fdebench_problem_order(const fdebench_problem* problem, size_t unknown, double* order) {
  return guarded([&] {
    const auto& rows = given("problem", problem, problem_handle).known.problem.components;
    auto& result = given("order", order);
    require_index("unknown", unknown, rows.size());
    result = rows[unknown].order;
  });
}

int fdebench_problem_end(const fdebench_problem* problem, double* end) {
  return guarded([&] { given("end", end) = end_time(given("problem", problem, problem_handle).known); });
}

void fdebench_problem_free(fdebench_problem* problem) { delete problem; }
