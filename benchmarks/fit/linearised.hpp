// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/SVD>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "fdebench/schemes/problem/problem.hpp"

namespace fde::bench {

// The measurements do not determine parameters, as far as runs of this accuracy tell.
struct Undetermined : std::runtime_error {
  explicit Undetermined(std::vector<std::string> of)
      : std::runtime_error("parameters are not determined"), names(std::move(of)) {}
  std::vector<std::string> names;
};

// The residuals linearised at a minimum, r + J dz, as a function of the free variables z.
class Linearised {
 public:
  // `noise`: of a difference of residuals over `difference` of a variable. Throws Undetermined naming
  // variables of which no more than that is seen.
  Linearised(const Matrix& jacobian, double difference, double noise, const std::vector<std::string>& names);

  // The change of z by which the residuals become least.
  [[nodiscard]] Vec step(const Vec& residuals) const { return -svd_.solve(residuals).cwiseQuotient(sizes_); }

  // The covariance of z, of residuals with variance 1.
  [[nodiscard]] Matrix covariance() const {
    const Matrix root = sizes_.cwiseInverse().asDiagonal() * svd_.matrixV() *
                        svd_.singularValues().cwiseInverse().asDiagonal();
    return root * root.transpose();
  }

 private:
  Vec sizes_;                    // of the columns of J
  Eigen::BDCSVD<Matrix> svd_{};  // of J with columns of size 1
};

}  // namespace fde::bench
