// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "fdebench/reports/analysis/runs.hpp"

namespace fde::bench {

// The errors of the lines of one scene over a grid, and from each number of steps to the next the observed
// order log(e1 / e2) / log(N2 / N1).
struct ObservedOrders {
  struct Row {
    int steps;
    double h, error;
    std::optional<double> order{};  // nullopt: the first row, or an error that is 0
  };
  struct Line {
    std::string name;
    std::optional<double> expected{};  // by theory
    std::vector<Row> rows{};
  };
  std::vector<Line> lines{};
};

// Of the schemes with these ids, or without any of all. `expected`: the quantity with the theoretical rate.
ObservedOrders observed_orders(const Runs& runs, const SceneSettings& scene, std::string_view error,
                               std::string_view expected, const std::vector<std::string>& schemes);

// scheme,steps,h,error,order,expected: a row a run.
std::string csv_of(const ObservedOrders& orders);
// A tabular environment that needs no package: a row a number of steps, two columns a scheme, and in the last
// row the orders by theory.
std::string latex_of(const ObservedOrders& orders);

}  // namespace fde::bench
