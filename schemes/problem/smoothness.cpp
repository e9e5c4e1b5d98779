#include "smoothness.hpp"

#include <algorithm>
#include <cmath>

namespace fde {

std::vector<double> power_lattice(const std::vector<double>& start, const std::vector<double>& steps,
                                  double last) {
  constexpr double same = 1e-12;
  std::vector<double> powers;
  std::vector<double> open = start;
  while (!open.empty()) {
    const double p = open.back();
    open.pop_back();
    if (p > last || std::ranges::any_of(powers, [&](double q) { return std::abs(p - q) < same; })) continue;
    powers.push_back(p);
    for (const double step : steps) open.push_back(p + step);
  }
  std::ranges::sort(powers);
  return powers;
}

}  // namespace fde
