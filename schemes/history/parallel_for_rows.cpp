// SPDX-License-Identifier: MIT
#include "fdebench/schemes/history/parallel_for_rows.hpp"

#include <algorithm>
#include <future>
#include <vector>

namespace fde {
namespace {

constexpr Eigen::Index rows_of_a_part = 2048;  // about ten such columns fit into a cache of 256 KB
constexpr Eigen::Index fewest_of_a_thread =
    8192;  // a step of so many rows takes as long as starting a thread

}  // namespace

void parallel_for_rows(int threads, Eigen::Index rows, Eigen::Index unit,
                       const std::function<void(Eigen::Index first, Eigen::Index count)>& work) {
  const Eigen::Index part = std::max(rows_of_a_part / unit, Eigen::Index{1}) * unit;
  const Eigen::Index parts = (rows + part - 1) / part;
  const Eigen::Index workers = std::clamp<Eigen::Index>(rows / fewest_of_a_thread, 1, std::max(threads, 1));
  const auto work_on = [&](Eigen::Index worker) {
    for (Eigen::Index i = parts * worker / workers; i < parts * (worker + 1) / workers; ++i)
      work(i * part, std::min(part, rows - i * part));
  };
  std::vector<std::future<void>> others;
  for (Eigen::Index worker = 1; worker < workers; ++worker)
    others.push_back(std::async(std::launch::async, work_on, worker));
  work_on(0);
  for (auto& other : others) other.get();
}

}  // namespace fde
