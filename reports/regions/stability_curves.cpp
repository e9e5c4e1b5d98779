// SPDX-License-Identifier: MIT
#include "fdebench/reports/regions/stability_curves.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <thread>

#include "fdebench/benchmarks/sweep/in_parallel.hpp"
#include "fdebench/schemes/diagnostics/stability_region.hpp"

namespace fde::bench {
namespace {

using nlohmann::json;

double rounded(double x) { return std::round(1e4 * x) / 1e4; }

json pieces_of(const Scheme& scheme, double order, int points) {
  if (unsupported_reason(scheme, test_problem(scheme, order, -1.0), {})) return {};
  json pieces = json::array();
  // The curves of implicit rules are longer, and cheap to compute.
  for (const auto& piece :
       region_boundary(scheme, order, scheme.capabilities.implicit ? 2 * points : points)) {
    json flat = json::array();
    for (const auto& [theta, z] : piece) {
      flat.push_back(rounded(z.real()));
      flat.push_back(rounded(std::abs(z.imag())));
    }
    pieces.push_back(std::move(flat));
  }
  return pieces;
}

}  // namespace

std::vector<const Scheme*> all_schemes() {
  std::vector<const Scheme*> all;
  for (const Scheme& scheme : schemes()) all.push_back(&scheme);
  return all;
}

json stability_curves(const std::vector<const Scheme*>& schemes, const std::vector<double>& orders,
                      int points) {
  std::vector<const Scheme*> some;
  std::ranges::copy_if(schemes, std::back_inserter(some),
                       [](const Scheme* scheme) { return static_cast<bool>(scheme->symbol); });
  std::vector curves(some.size(), std::vector<json>(orders.size()));
  in_parallel(some.size() * orders.size(), std::max(1U, std::thread::hardware_concurrency()),
              [&](std::size_t i) {
                const auto scheme = i / orders.size(), order = i % orders.size();
                curves[scheme][order] = pieces_of(*some[scheme], orders[order], points);
              });
  json listed = json::object(), same = json::object();
  for (std::size_t i = 0; i < some.size(); ++i) {
    const auto earlier = static_cast<std::size_t>(std::ranges::find(curves, curves[i]) - curves.begin());
    if (earlier < i) {
      same[some[i]->id] = some[earlier]->id;
    } else {
      listed[some[i]->id] = curves[i];
    }
  }
  return {{"orders", orders}, {"curves", std::move(listed)}, {"same", std::move(same)}};
}

json page_stability_curves(const std::vector<const Scheme*>& schemes) {
  return stability_curves(schemes, {0.1, 0.3, 0.5, 0.7, 0.9, 1.1, 1.3, 1.5, 1.7, 1.9}, 32);
}

}  // namespace fde::bench
