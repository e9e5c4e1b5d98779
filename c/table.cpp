// SPDX-License-Identifier: MIT
#include <algorithm>
#include <limits>
#include <memory>
#include <utility>

#include "fdebench/benchmarks/equation_files/equation_scene.hpp"
#include "fdebench/benchmarks/requests/exact.hpp"
#include "fdebench/benchmarks/scenes/variant.hpp"
#include "fdebench/c/guard.hpp"
#include "fdebench/c/handles.hpp"
#include "fdebench/reports/command/solved_table.hpp"

namespace fde::bench::c {
namespace {

// The variant that the text of a scene names now: equation files may have changed.
template <typename Make>
Scene scene_of(const FdebenchProblem& problem, const Make& make) {
  if (problem.scene.empty()) return problem.known;
  const SceneRegistry all = with_equation_files(built_in_scenes());
  return make(read_variant(problem.scene, {}, all));
}

FdebenchTable table_of_solve(SolvedTable&& solved) {
  FdebenchTable table{.names = std::move(solved.names),
                      .times = std::move(solved.times),
                      .values = std::move(solved.values),
                      .facts = nlohmann::json::parse(solved.cost)};
  table.facts["cost"] = solved.cost;
  table.facts["warning"] = solved.warning;
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
    const auto& texts = given("options", options, options_handle).texts;
    const auto checked = [](const SceneVariant& variant) { return make_scene(variant); };
    const auto given_options = given_to_solve(text_of("scheme", scheme), texts);
    result = std::make_unique<FdebenchTable>(
                 table_of_solve(solved_table(scene_of(handle, checked), given_options)))
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
    const auto unchecked = [](const SceneVariant& variant) {
      return make_scene_unchecked(*variant.maker, variant.values);
    };
    result =
        std::make_unique<FdebenchTable>(table_of_exact(exact(scene_of(handle, unchecked), at), at)).release();
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
