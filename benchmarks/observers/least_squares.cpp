#include "fdebench/benchmarks/observers/least_squares.hpp"

#include <Eigen/QR>

namespace fde {

LongMatrix least_squares(const LongMatrix& a, const LongMatrix& b) {
  const Eigen::ColPivHouseholderQR<LongMatrix> orthogonal(a);
  LongMatrix x(a.cols(), b.cols());
  for (Eigen::Index j = 0; j < b.cols(); ++j) x.col(j) = orthogonal.solve(LongVec(b.col(j)));
  return x;
}

}  // namespace fde
