#pragma once

#include "collocation/panel_basis.hpp"
#include "two_sided/nodal_basis.hpp"

namespace fde {

// t = v^q / (v^q + (1-v)^q), q = 8, where v(x) is the cubic with v(0) = 0, v(1) = 1 and dt/dx = 2 in the
// middle: what starts like a small power of t, or of 1-t, is smooth in x (R. Kress, Linear Integral
// Equations, 1999, section 12.2).
BothShares clustered(BothShares x);
BothShares unclustered(BothShares t);

// Polynomials in x through Gauss points on equal panels. `points` belongs to the basis of a panel.
NodalBasis clustered_panels(const PanelBasis& panel, int panels);

}  // namespace fde
