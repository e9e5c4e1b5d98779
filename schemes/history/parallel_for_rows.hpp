// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <functional>

namespace fde {

// Calls work(first, count) for parts that partition `rows` rows. Part sizes are multiples of `unit`, except
// the last, and fit into the cache. At most `threads` threads are used, each for neighbouring parts; few rows
// are processed by one thread. Precondition: work writes to its own rows only, so the result does not depend
// on the number of threads. Rethrows an exception of a part after all parts of other threads have ended.
void parallel_for_rows(int threads, Eigen::Index rows, Eigen::Index unit,
                       const std::function<void(Eigen::Index first, Eigen::Index count)>& work);

}  // namespace fde
