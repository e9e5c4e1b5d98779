// SPDX-License-Identifier: MIT
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <memory>
#include <utility>

#include "fdebench/benchmarks/equation_files/equation_scene.hpp"
#include "fdebench/benchmarks/scenes/variant.hpp"
#include "fdebench/benchmarks/text/number_text.hpp"
#include "fdebench/c/guard.hpp"
#include "fdebench/c/handles.hpp"
#include "fdebench/reports/command/solved_table.hpp"

namespace fde::bench::c {
namespace {

// The scene with the end that its text names; the caller's problem.
Scene posed_scene(const FdebenchProblem& problem) {
  if (problem.scene.empty()) return problem.known;
  const SceneRegistry all = with_equation_files(built_in_scenes());
  return make_scene(read_variant(problem.scene, {}, all));
}

std::string reason_of(const std::string& line) {
  constexpr std::string_view speaker = "warning: ";
  return line.starts_with(speaker) ? line.substr(speaker.size()) : line;
}

FdebenchTable table_of_solve(SolvedTable&& solved) {
  FdebenchTable table{.names = std::move(solved.names),
                      .times = std::move(solved.times),
                      .values = std::move(solved.values),
                      .facts = nlohmann::json::parse(solved.cost)};
  table.facts["cost"] = solved.cost;
  table.facts["warning"] = reason_of(solved.warning);
  table.facts["ended"] = solved.ended;
  return table;
}

// Copies a matrix of one column for each time, which is row after row of the table.
void copy(const Matrix& from, double* into, const char* name, std::size_t capacity) {
  require_capacity(capacity, static_cast<std::size_t>(from.size()));
  std::copy_n(from.data(), from.size(), &given(name, into));
}

constexpr auto table_handle = "a handle of fdebench_solve or fdebench_exact";

// The lines of `fdebench exact --bounds` by their times. A line has the time, the columns, the largest bound,
// and a bound of each of the first columns.
std::map<double, std::vector<double>> rows_by_time(std::string_view text) {
  std::map<double, std::vector<double>> rows;
  text.remove_prefix(text.find('\n') + 1);
  while (!text.empty()) {
    const auto length = text.find('\n');
    auto numbers = try_parse_numbers(text.substr(0, length)).value();
    rows.emplace(numbers.front(), std::move(numbers));
    text.remove_prefix(length + 1);
  }
  return rows;
}

FdebenchTable table_of_exact(const Scene& scene, std::vector<double> times, const std::string& csv) {
  const auto rows = rows_by_time(csv);
  FdebenchTable table{.names = printed_names(scene), .times = std::move(times)};
  if (scene.reactions.has_exact_multipliers())
    std::ranges::copy(reaction_names(scene), std::back_inserter(table.names));
  const auto columns = std::ssize(table.names), bounded = std::ssize(scene.outputs.names);
  table.values.resize(columns, std::ssize(table.times));
  table.bounds = Matrix::Constant(columns, std::ssize(table.times), std::numeric_limits<double>::quiet_NaN());
  for (Eigen::Index i = 0; i < std::ssize(table.times); ++i) {
    const auto& row = rows.at(table.times[static_cast<std::size_t>(i)]);
    table.values.col(i) = Eigen::Map<const Vec>(row.data() + 1, columns);
    table.bounds.col(i).head(bounded) = Eigen::Map<const Vec>(row.data() + row.size() - bounded, bounded);
  }
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
    const auto given_options = given_to_solve(text_of("scheme", scheme), texts);
    result = std::make_unique<FdebenchTable>(table_of_solve(solved_table(posed_scene(handle), given_options)))
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
    for (const double t : at) {
      if (!(t >= 0.0 && std::isfinite(t)))
        throw std::invalid_argument(fmt::format("times = {}: must be numbers >= 0", t));
    }
    const auto csv = output_for(handle, "exact", {"--bounds", fmt::format("--at={}", fmt::join(at, ","))});
    result = std::make_unique<FdebenchTable>(table_of_exact(handle.known, at, csv)).release();
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
