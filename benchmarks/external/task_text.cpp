// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/external/task_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string>
#include <system_error>
#include <utility>
#include <variant>
#include <vector>

#include "fdebench/schemes/problem/chain.hpp"

namespace fde::bench {
namespace {

using Json = nlohmann::ordered_json;

constexpr int format = 1;

// All parameters, defaults included. One that follows from others is given as its formula.
Json parameters_of(const SceneVariant& variant) {
  Json parameters = Json::object();
  for (const Parameter& parameter : variant.factory->parameters) {
    const auto found = variant.values.find(parameter.name);
    const ParameterValue& value = found == variant.values.end() ? parameter.value : found->second;
    std::visit([&](const auto& of) { parameters[parameter.name] = of; }, value);
  }
  return parameters;
}

Json rows_of(const Problem& problem) {
  Json rows = Json::array();
  for (const Component& component : problem.components) {
    rows.push_back({{"order", component.order},
                    {"initial", component.initial},
                    {"side", component.side == Side::left ? "left" : "right"}});
  }
  return rows;
}

Json equations_of(const std::vector<EquationFormula>& equations) {
  Json all = Json::array();
  for (const auto& [unknown, terms, rhs, initial, final] : equations) {
    Json of_unknown = Json::array();
    for (const auto& [coefficient, order] : terms) of_unknown.push_back({coefficient, order});
    all.push_back({{"unknown", unknown}, {"terms", of_unknown}, {"rhs", rhs}, {"initial", initial}});
    if (!final.empty()) all.back()["final"] = final;
  }
  return all;
}

// For each row the name of the column that is this row; null: none is. Found by evaluating the columns at a
// state of different numbers.
Json columns_of_rows(const Scene& scene) {
  const auto size = scene.problem.size();
  Vec state(size);
  for (Eigen::Index i = 0; i < size; ++i) state[i] = std::sqrt(static_cast<double>(i) + 2.0);
  const auto values = columns_at(scene.outputs, std::sqrt(0.5) * scene.problem.end, state);
  Json names = Json::array();
  for (Eigen::Index i = 0; i < size; ++i) {
    const auto found = std::ranges::find(values, state[i]);
    names.push_back(found == values.end()
                        ? Json()
                        : Json(scene.outputs.names[static_cast<std::size_t>(found - values.begin())]));
  }
  return names;
}

// The rows of the problem as formulas: D^order y_i = rhs[i], and y_i is the column columns[i].
Json system_of(const Scene& scene, const ProblemText& text) {
  return {{"columns", columns_of_rows(scene)}, {"rhs", text.rhs}, {"jacobian", text.jacobian}};
}

// Whether the formula contains a variable y_i other than these, which are numbered from 1.
bool has_others(const std::string& formula, const std::vector<Eigen::Index>& variables) {
  for (std::size_t at = formula.find('y'); at != std::string::npos; at = formula.find('y', at + 1)) {
    Eigen::Index number = 0;
    const char* const end = formula.data() + formula.size();
    const auto [after, error] = std::from_chars(formula.data() + at + 1, end, number);
    if (error == std::errc() && std::ranges::find(variables, number) == variables.end()) return true;
  }
  return false;
}

// The multi-term equations sum_k coefficients[k] D^(orders[k]) y_i = rhs, one for each chain of rows and each
// other row. Null if there is an algebraic or a right row, if a force contains a derivative of an unknown, or
// with conditions at both ends.
Json multi_term_of(const Problem& problem, const std::vector<std::string>& rhs) {
  if (problem.conditions) return {};
  Json equations = Json::array();
  std::vector<Eigen::Index> first_rows;
  std::vector<std::string> forces;
  const auto add = [&](const Chain& chain, const std::string& force) {
    auto terms = chain.terms();
    terms.push_back(chain.leading());
    Json coefficients = Json::array(), orders = Json::array();
    for (const auto& [coefficient, order] : terms) {
      coefficients.push_back(coefficient);
      orders.push_back(order);
    }
    first_rows.push_back(chain.first_row() + 1);
    forces.push_back(force);
    equations.push_back({{"unknown", fmt::format("y{}", first_rows.back())},
                         {"coefficients", coefficients},
                         {"orders", orders},
                         {"initial", chain.initial()},
                         {"rhs", force}});
    return chain.first_row() + chain.size();
  };
  for (Eigen::Index row = 0; row < problem.size();) {
    const auto found = std::ranges::find(problem.equations, row, &Equation::first_row);
    const auto& [order, initial, side] = problem.component(row);
    if (found != problem.equations.end()) {
      row = add(chain_of(problem, *found), found->force_text ? found->force_text() : "");
    } else {
      if (order == 0.0 || side == Side::right) return {};
      row = add(Chain::single_row({1.0, order}, initial, row), rhs[static_cast<std::size_t>(row)]);
    }
  }
  const bool is_multi_term = std::ranges::all_of(
      forces, [&](const auto& force) { return !force.empty() && !has_others(force, first_rows); });
  return is_multi_term ? equations : Json();
}

}  // namespace

std::string task_json(const SceneVariant& variant, const Scene& scene, const RunSettings& settings,
                      const std::vector<double>& times, TaskPurpose purpose) {
  Json task{{"format", format},
            {"scene", variant.factory->id},
            {"label", variant.label()},
            {"parameters", parameters_of(variant)},
            {"rows", rows_of(scene.problem)},
            {"columns", scene.outputs.names},
            {"end_time", scene.problem.end},
            {"steps", std::get<int>(settings.resolution)},
            {"grid", grid_text(settings.grading)},
            {"times", times},
            {"timed", purpose == TaskPurpose::times}};
  if (!variant.factory->equations.empty()) task["equations"] = equations_of(variant.factory->equations);
  if (const auto text = scene.problem.text ? scene.problem.text() : ProblemText{}; !text.rhs.empty()) {
    task["system"] = system_of(scene, text);
    if (auto equations = multi_term_of(scene.problem, text.rhs); !equations.is_null())
      task["multi_term"] = std::move(equations);
  }
  if (!scene.problem.jump_times.empty()) task["jumps"] = scene.problem.jump_times;
  if (std::isfinite(settings.budget)) task["budget"] = settings.budget;
  return task.dump(1) + '\n';
}

}  // namespace fde::bench
