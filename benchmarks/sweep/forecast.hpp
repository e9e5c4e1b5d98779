#pragma once

#include <functional>

#include "sweep/sweep.hpp"

namespace fde {

double total_seconds(const Forecast& forecast);

// Three solves with few steps say how long the steps of each scheme on each scene take and how fast its
// result converges. With these errors and times the ladder is climbed as the sweep climbs it; what is
// recorded is taken as it is and not expected. Without a goal the runs are all those of the sweep; what they
// take is a guess in any case, also for the references.
Forecast forecast(const Sweep& sweep, const std::function<RecordedRun(const RunKey&)>& recorded);

}  // namespace fde
