#pragma once

#include <vector>

namespace fde {

// The steps at which a run of this many is compared with the reference: all of them up to `most`, beyond that
// the first 16 and `most` spread evenly.
std::vector<int> watched_steps(int steps, int most = 8192);

}  // namespace fde
