#pragma once

#include <vector>

#include "measures/error_kind.hpp"
#include "stepping/trajectory.hpp"

namespace fde {

// Which runs of a scene are accurate enough.
struct Question {
  ErrorKind kind{};
  double accuracy = 1e-6;
  std::vector<Eigen::Index> columns{};  // of the scene, those that count
};

}  // namespace fde
