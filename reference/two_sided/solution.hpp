#pragma once

#include "nonlinear/panel_table.hpp"

namespace fde {

// Reference solution of a problem with right rows or conditions at both ends, at all times at once: by
// collocation on panels after a change of time that clusters them at both ends, and by sinc functions after
// another. The bound is twice the largest difference of the two, and of two resolutions of the first, on a
// panel and the next ones, with an allowance for rounding. Orders are positive, f is finite at both ends.
//
// The panels are those of x end with t = ClusteredTime(x), the more clustered the smaller the smallest order
// is: two_sided_reference is told times t.
// Throws std::runtime_error where one of the methods does not converge, std::invalid_argument for algebraic
// rows.
PanelTable two_sided_table(const Problem& problem);
Reference two_sided_reference(PanelTable table, const Problem& problem);

}  // namespace fde
