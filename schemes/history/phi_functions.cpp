#include "history/phi_functions.hpp"

#include <algorithm>

namespace fde {

// The functions follow from each other by phi_k = 1/k! - x phi_(k+1): upwards without loss for small x,
// downwards for large.
void phi_functions(const Vec& x, Matrix& phi, Vec& decay_minus_one) {
  constexpr int last = 18;  // 1/22! is rounding
  const Eigen::Index few = std::lower_bound(x.begin(), x.end(), 1.0) - x.begin(), many = x.size() - few;
  const auto small = x.head(few).array(), large = x.tail(many).array();
  auto low = phi.topRows(few).array(), high = phi.middleRows(few, many).array();
  low.col(2).setOnes();
  for (int i = last; i >= 0; --i) low.col(2) = 1.0 - small * low.col(2) * (1.0 / (i + 4));
  low.col(2) *= 1.0 / 6.0;
  low.col(1) = 0.5 - small * low.col(2);
  low.col(0) = 1.0 - small * low.col(1);
  decay_minus_one.head(few) = -small * low.col(0);

  decay_minus_one.segment(few, many) = (-large).exp() - 1.0;
  high.col(0) = -decay_minus_one.segment(few, many).array() / large;
  high.col(1) = (1.0 - high.col(0)) / large;
  high.col(2) = (0.5 - high.col(1)) / large;
}

}  // namespace fde
