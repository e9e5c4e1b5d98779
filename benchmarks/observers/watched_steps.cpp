#include "observers/watched_steps.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>

namespace fde {

std::vector<int> watched_steps(int steps, int most) {
  constexpr int first = 16;
  std::vector<int> watched(static_cast<std::size_t>(std::min(steps, most)) + 1);
  std::iota(watched.begin(), watched.end(), 0);
  if (steps <= most) return watched;
  for (auto& n : watched) n = static_cast<int>(std::int64_t{n} * steps / most);
  for (int n = 0; n <= first; ++n) watched.push_back(n);
  std::ranges::sort(watched);
  watched.erase(std::unique(watched.begin(), watched.end()), watched.end());
  return watched;
}

std::vector<double> watched_times(const Grid& grid, int most) {
  std::vector<double> times;
  for (const int n : watched_steps(grid.steps, most)) times.push_back(grid.time(n));
  return times;
}

}  // namespace fde
