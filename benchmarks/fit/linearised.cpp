// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/fit/linearised.hpp"

#include <cmath>

namespace fde::bench {

Linearised::Linearised(const Matrix& jacobian, double difference, double noise,
                       const std::vector<std::string>& names)
    : sizes_(jacobian.colwise().norm()) {
  constexpr double clear = 10.0, large = 0.3;
  const auto named = [&](const auto& is_meant) {
    std::vector<std::string> some;
    for (std::size_t j = 0; j < names.size(); ++j)
      if (is_meant(static_cast<Eigen::Index>(j))) some.push_back(names[j]);
    return some;
  };
  auto unseen = named([&](Eigen::Index j) { return !(sizes_[j] * difference > clear * noise); });
  if (!unseen.empty()) throw Undetermined(std::move(unseen));
  svd_.compute(jacobian * sizes_.cwiseInverse().asDiagonal(), Eigen::ComputeThinU | Eigen::ComputeThinV);
  const auto last = sizes_.size() - 1;
  if (svd_.singularValues()[last] > clear * noise / (difference * sizes_.minCoeff())) return;
  throw Undetermined(named([&](Eigen::Index j) { return std::abs(svd_.matrixV()(j, last)) > large; }));
}

}  // namespace fde::bench
