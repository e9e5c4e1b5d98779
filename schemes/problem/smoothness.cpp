// SPDX-License-Identifier: MIT
#include "fdebench/schemes/problem/smoothness.hpp"

#include <set>
#include <utility>

namespace fde {

std::vector<double> power_closure(std::vector<double> start, double last,
                                  const std::function<std::vector<double>(double p)>& next) {
  std::set<double> powers;
  std::vector<double> open = std::move(start);
  while (!open.empty()) {
    const double p = open.back();
    open.pop_back();
    const auto near = powers.lower_bound(p - power_separation);
    if (p > last || (near != powers.end() && *near < p + power_separation)) continue;
    powers.insert(p);
    for (const double following : next(p)) open.push_back(following);
  }
  return {powers.begin(), powers.end()};
}

std::vector<double> power_lattice(const std::vector<double>& start, const std::vector<double>& steps,
                                  double last) {
  return power_closure(start, last, [&](double p) {
    std::vector<double> following = steps;
    for (double& step : following) step += p;
    return following;
  });
}

}  // namespace fde
