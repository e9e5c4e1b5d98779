// SPDX-License-Identifier: MIT
#include <algorithm>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "fdebench/benchmarks/equation_files/equation_scene.hpp"
#include "fdebench/benchmarks/requests/answers_json.hpp"
#include "fdebench/benchmarks/requests/exact.hpp"
#include "fdebench/benchmarks/requests/solve.hpp"
#include "fdebench/benchmarks/scenes/variant.hpp"
#include "fdebench/benchmarks/text/number_text.hpp"
#include "fdebench/c/guard.hpp"
#include "fdebench/c/handles.hpp"

namespace fde::bench::c {
namespace {

// The variant that the text of a scene names now: equation files may have changed.
Scene scene_of(const FdebenchProblem& problem, Scene (*make)(const SceneVariant&)) {
  if (problem.scene.empty()) return problem.known;
  const SceneRegistry all = with_equation_files(built_in_scenes());
  return make(read_variant(problem.scene, {}, all));
}

SolveRequest request_of(const std::string& scheme, const std::map<std::string, OptionValue>& values) {
  SolveRequest request{.scheme = scheme};
  std::optional<double> accuracy;
  std::optional<std::vector<double>> at;
  std::optional<int> steps, every, points;
  for (const auto& [name, value] : values) {
    if (name == "accuracy") {
      accuracy = real_of(name, value, positive);
    } else if (name == "at") {
      at = reals_of(name, value, not_negative);
    } else if (name == "budget") {
      request.settings.budget = real_of(name, value, positive);
    } else if (name == "check") {
      request.check = count_of(name, value, {0, 1}) == 1;
    } else if (name == "every") {
      every = count_of(name, value, step_counts);
    } else if (name == "grid") {
      set_grid(request, text_of(value));
    } else if (name == "history") {
      request.settings.history = parse_history(text_of(value));
    } else if (name == "points") {
      points = count_of(name, value, point_counts);
    } else if (name == "steps") {
      steps = count_of(name, value, step_counts);
    } else if (name == "threads") {
      request.threads = count_of(name, value, thread_counts);
    } else if (name == "tolerance") {
      request.settings.newton_tolerance = real_of(name, value, newton_tolerances);
    } else {
      reject_text("option", name,
                  "of accuracy, at, budget, check, every, grid, history, points, steps, threads, tolerance");
    }
  }
  request.settings.resolution = resolution_from(steps, accuracy);
  request.times = output_times_from(std::move(at), every, points);
  return request;
}

FdebenchTable table_of_solve(SolvedTable&& solved) {
  const auto cost = json_of(solved.cost);
  FdebenchTable table{.names = std::move(solved.names),
                      .times = std::move(solved.times),
                      .values = std::move(solved.values),
                      .facts = cost};
  table.facts["cost"] = cost.dump();
  table.facts["warning"] = warning_text(solved.warnings);
  table.facts["ended"] = solved.ended;
  return table;
}

// Copies a matrix of one column for each time, which is row after row of the table.
void copy(const Matrix& from, double* into, const char* name, std::size_t capacity) {
  require_capacity(capacity, static_cast<std::size_t>(from.size()));
  std::copy_n(from.data(), from.size(), &given(name, into));
}

constexpr auto table_handle = "a handle of fdebench_solve or fdebench_exact";

// A column without bounds has bounds that are no numbers.
FdebenchTable table_of_exact(ExactTable&& known, std::vector<double> times) {
  FdebenchTable table{
      .names = std::move(known.names), .times = std::move(times), .values = std::move(known.values)};
  table.bounds =
      Matrix::Constant(table.values.rows(), table.values.cols(), std::numeric_limits<double>::quiet_NaN());
  table.bounds.topRows(known.bounds.rows()) = known.bounds;
  return table;
}

}  // namespace
}  // namespace fde::bench::c

using namespace fde::bench;
using namespace fde::bench::c;

int fdebench_solve(const fdebench_problem* problem, const char* scheme, const fdebench_options* options,
                   fdebench_table** table) {
  return guarded([&] {
    auto& result = given("table", table);
    const auto& handle = given("problem", problem, problem_handle);
    const auto& values = given("options", options, options_handle).values;
    const auto request = request_of(text_of("scheme", scheme), values);
    result = std::make_unique<FdebenchTable>(table_of_solve(solve(scene_of(handle, make_scene), request)))
                 .release();
  });
}

int fdebench_exact(const fdebench_problem* problem, size_t count, const double* times,
                   fdebench_table** table) {
  return guarded([&] {
    auto& result = given("table", table);
    const auto& handle = given("problem", problem, problem_handle);
    require_count("count", count, 1, most_entries);
    const std::vector<double> at(&given("times", times, "the times"), times + count);
    result =
        std::make_unique<FdebenchTable>(table_of_exact(exact(scene_of(handle, make_scene_unchecked), at), at))
            .release();
  });
}

int fdebench_table_size(const fdebench_table* table, size_t* times, size_t* columns) {
  return guarded([&] {
    const auto& known = given("table", table, table_handle);
    auto& rows = given("times", times);
    given("columns", columns) = known.names.size();
    rows = known.times.size();
  });
}

int fdebench_table_name(const fdebench_table* table, size_t column, const char** name) {
  return guarded([&] {
    const auto& names = given("table", table, table_handle).names;
    auto& result = given("name", name);
    require_index("column", column, names.size());
    result = names[column].c_str();
  });
}

int fdebench_table_times(const fdebench_table* table, double* times, size_t capacity) {
  return guarded([&] {
    const auto& known = given("table", table, table_handle).times;
    require_capacity(capacity, known.size());
    std::ranges::copy(known, &given("times", times));
  });
}

int fdebench_table_values(const fdebench_table* table, double* values, size_t capacity) {
  return guarded([&] { copy(given("table", table, table_handle).values, values, "values", capacity); });
}

int fdebench_table_bounds(const fdebench_table* table, double* bounds, size_t capacity) {
  return guarded([&] {
    const auto& known = given("table", table, table_handle);
    if (known.bounds.size() == 0)
      throw std::invalid_argument("table: must be of fdebench_exact, which has bounds");
    copy(known.bounds, bounds, "bounds", capacity);
  });
}

int fdebench_table_number(const fdebench_table* table, const char* fact, double* number) {
  return guarded([&] {
    const auto& facts = given("table", table, table_handle).facts;
    given("number", number) = number_in(facts, text_of("fact", fact));
  });
}

int fdebench_table_text(const fdebench_table* table, const char* fact, const char** text) {
  return guarded([&] {
    const auto& facts = given("table", table, table_handle).facts;
    given("text", text) = text_in(facts, text_of("fact", fact));
  });
}

void fdebench_table_free(fdebench_table* table) { delete table; }
