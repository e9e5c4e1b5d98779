#pragma once

#include <functional>
#include <vector>

#include "search/attempt.hpp"

namespace fde {

// The attempt with the fewest steps within the accuracy, or nearly so. The ladder's last attempt is the only
// one within it. Numbers of steps are multiples of the unit. With `scan` all numbers of steps down to a
// sixteenth are tried, a twentieth apart, and those between two of which the error changes its sign.
Attempt fewest_steps(const std::vector<Attempt>& ladder, double accuracy, int unit, bool scan,
                     const std::function<Attempt(int steps)>& attempt);

// About a hundredth more.
int more_steps(int steps, int unit);

}  // namespace fde
