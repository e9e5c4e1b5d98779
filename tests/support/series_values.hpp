// SPDX-License-Identifier: MIT
#pragma once

// The motion of fractional_constraint_nonlinear, with default parameters except alpha, from its power series
// in t^(1/10): 300 terms in 60 digits with mpmath, term by term from q' = v, v' = a + d lambda, w =
// J^(1-alpha) v and f = 0. The values are independent of this code.

#include <vector>

#include "fdebench/schemes/problem/vectors.hpp"

namespace fde::bench {

struct SeriesValue {
  double alpha, t;
  Vec columns;  // q1, q2, v1, v2, w1, w2
};

inline const std::vector<SeriesValue>& series_values() {
  static const std::vector<SeriesValue> all{
      {0.6, 0.15,
       Vec{{1.0604863225993711, 0.12037310490475161, 0.23850362183156704, 0.8373722033962794,
            0.17533129831642221, 0.43157535894571148}}},
      {0.7, 0.1,
       Vec{{1.0444002147467908, 0.077055472394450473, 0.33277207584177072, 0.79788430864886852,
            0.21427468717729737, 0.43836889175877962}}},
      {0.8, 0.08,
       Vec{{1.0358442018655142, 0.059287907487212871, 0.3598067339586779, 0.76592417899851525,
            0.2555817853613109, 0.49770643976012992}}}};
  return all;
}

}  // namespace fde::bench
