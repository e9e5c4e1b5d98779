#pragma once

#include <map>
#include <string>
#include <vector>

#include "scenes/scene.hpp"

namespace fde {

// The reference of one scene at the times of its runs, each time evaluated once: refined grids share their
// times. The scene must live as long.
class WatchedReference {
 public:
  explicit WatchedReference(const Scene& scene);

  // Of these columns of the scene alone, by their place among its names.
  WatchedReference(const Scene& scene, std::vector<Eigen::Index> columns);

  // The columns at these times, one column a time. Throws std::runtime_error where there is no
  // reference to be had, a Singularity where that is why.
  Rows at(const std::vector<double>& times);

  // What these are off by at most, or an estimate of that.
  Rows bounds(const std::vector<double>& times);

 private:
  const ReferenceValue& reference(double t);
  ReferenceValue evaluated(double t);

  const Scene& scene_;
  std::vector<Eigen::Index> columns_;
  Reference exact_{};             // made when first asked for
  std::exception_ptr failure_{};  // why there is none: the same for every time
  std::map<double, ReferenceValue> known_{};
};

}  // namespace fde
