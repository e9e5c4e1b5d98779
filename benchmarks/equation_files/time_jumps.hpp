#pragma once

#include <functional>
#include <vector>

#include "equation_files/equation_system.hpp"

namespace fde {

// For an end T the times after 0 at which the rows jump because of t alone, increasing: those that the file
// declares, and those up to T at which the argument of a sign or a step changes its sign and depends on t
// alone. Changes are located to the last bit between 8192 equal steps of [0, T], and between T/2, T/4, ...
// near 0: two within one of these are not seen.
std::function<std::vector<double>(double end)> time_jumps(const EquationSystem& system,
                                                          const Expressions& all);

}  // namespace fde
