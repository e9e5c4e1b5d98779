#pragma once

#include <vector>

#include "search/searched_way.hpp"

namespace fde {

// Looks for the cheapest run of a scene that answers a question, over all schemes, gradings and numbers of
// steps, for so many seconds. Every way doubles its steps until it is within the accuracy, or is known to be
// slower than another. Then the fewest steps are found between the last two by the error model, each taken by
// a run; at the end, where an error may pass through 0, all numbers below them in steps of a twentieth. The
// quickest are timed against each other, and the first of them is compared with the reference at as many
// steps as records are. First those within the accuracy, the quickest first.
std::vector<SearchedWay> search(const Scene& scene, const Question& question, double seconds,
                                const Tell& tell);

}  // namespace fde
