// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "fdebench/benchmarks/measures/error_kind.hpp"
#include "fdebench/schemes/problem/vectors.hpp"

namespace fde::bench {

// Which runs of a scene are accurate enough.
struct AccuracyTarget {
  ErrorKind kind{};
  double accuracy = 1e-6;
  std::vector<Eigen::Index> columns{};  // indices of the scene's columns that are compared
  // Whether a run takes the time of the first solve of a process, which computes start weights and tables
  // that later solves reuse; otherwise that of a later solve.
  bool first_run = false;
};

// Progress callback: `what` is being run, `part` in [0, 1] is the elapsed fraction of the time.
using SearchProgress = std::function<void(const std::string& what, double part)>;

}  // namespace fde::bench
