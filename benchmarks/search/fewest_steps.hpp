#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "search/attempt.hpp"

namespace fde {

// The attempt with the fewest steps within the accuracy, or nearly so. The ladder's last attempt is the only
// one within it. Numbers of steps are multiples of the unit. With `scan` all numbers of steps down to a
// sixteenth are tried, a twentieth apart, and those between two of which the error changes its sign.
Attempt fewest_steps(const std::vector<Attempt>& ladder, double accuracy, int unit, bool scan,
                     const std::function<Attempt(int steps)>& attempt);

// An attempt within the accuracy between two whose errors at the end have opposite signs: somewhere between
// them the error passes through 0. nullopt: it is small at no whole number of steps, or passes through
// infinity.
std::optional<Attempt> at_sign_change(Attempt few, Attempt many, int unit,
                                      const std::function<Attempt(int steps)>& attempt);

// About a hundredth more.
int more_steps(int steps, int unit);

}  // namespace fde
