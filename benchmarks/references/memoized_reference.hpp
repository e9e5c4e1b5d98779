// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <string>
#include <vector>

#include "fdebench/benchmarks/scenes/scene.hpp"

namespace fde::bench {

// The indices of all columns of the scene.
std::vector<Eigen::Index> all_columns(const Scene& scene);

// The cached reference of one scene: each time is evaluated once, because refined grids share times. The
// scene must outlive this object.
class MemoizedReference {
 public:
  explicit MemoizedReference(const Scene& scene);

  // Restricted to these columns of the scene, given by index.
  MemoizedReference(const Scene& scene, std::vector<Eigen::Index> columns);

  // The columns at these times, one column a time. Throws std::runtime_error if there is no reference; a
  // Singularity if a singularity of the solution is the reason.
  Rows at(const std::vector<double>& times);

  // Bounds of the errors of the columns, or estimates.
  Rows bounds(const std::vector<double>& times);

  // The reference of all columns, computed by the first call of any member; throws as `at` does.
  const reference::Reference& exact();

  // Whether the reference has been computed, or has failed.
  [[nodiscard]] bool is_begun() const { return exact_.at || failure_; }

 private:
  const reference::ReferenceValue& reference(double t);
  reference::ReferenceValue evaluated(double t);

  const Scene& scene_;
  std::vector<Eigen::Index> columns_;
  reference::Reference exact_{};  // created at the first evaluation
  std::exception_ptr failure_{};  // reason of a failure, the same for every time
  std::map<double, reference::ReferenceValue> known_{};
};

}  // namespace fde::bench
