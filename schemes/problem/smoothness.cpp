#include "smoothness.hpp"

#include <algorithm>
#include <utility>

namespace fde {

std::vector<double> power_closure(std::vector<double> start, double last,
                                  const std::function<std::vector<double>(double p)>& next) {
  std::vector<double> powers, open = std::move(start);
  while (!open.empty()) {
    const double p = open.back();
    open.pop_back();
    if (p > last || std::ranges::any_of(powers, [=](double q) { return same_order(p, q); })) continue;
    powers.push_back(p);
    for (const double following : next(p)) open.push_back(following);
  }
  std::ranges::sort(powers);
  return powers;
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
