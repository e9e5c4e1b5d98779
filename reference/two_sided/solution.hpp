// SPDX-License-Identifier: MIT
#pragma once

#include "fdebench/reference/nonlinear/panel_table.hpp"

namespace fde::reference {

// Reference solution of a problem with right derivatives or conditions at both ends, at all times at once: by
// collocation on panels clustered at both ends by a change of variable, and by sinc functions after another
// change of variable. The bound is twice the largest difference between the two, and between two resolutions
// of the first, on a panel and its neighbours, plus an allowance for rounding. Orders are positive, f is
// finite at both ends.
//
// The panels of the table are intervals of end * x with t = end * ClusteringMap(x), more clustered for a
// smaller smallest order; Reference::at takes times t, and throws std::invalid_argument for t outside
// [0, end]. Throws std::runtime_error where one of the methods does not converge, std::invalid_argument for
// algebraic rows.
PanelTable two_sided_table(const Problem& problem);
Reference two_sided_reference(PanelTable table, const Problem& problem);

}  // namespace fde::reference
