#pragma once

#include <Eigen/Core>
#include <functional>

namespace fde {

// Calls work(first, count) for parts of so many rows, which together are all of them: whole multiples of
// `unit`, but for the last, and small enough for the cache. Threads take neighbouring parts; where these are
// few, one does it all. Which thread has a part makes no difference to work that leaves the rows of others
// alone. An exception of any part reaches the caller when all have ended.
void share_work(int threads, Eigen::Index rows, Eigen::Index unit,
                const std::function<void(Eigen::Index first, Eigen::Index count)>& work);

}  // namespace fde
