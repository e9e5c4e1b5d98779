#pragma once

#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "stepping/scheme.hpp"

namespace fde {

// Where the regions of linear stability end, for charts: `orders`, and `curves`, by the ids of schemes for
// each of the orders the pieces of region_boundary in the upper half plane of z = lambda h^order, each piece
// as [re, im, re, im, ...], null where the scheme does not take the order. Schemes without a symbol are left
// out; `same` has those whose curves are all those of an earlier scheme, and its id. Points: of a curve,
// twice as many of an implicit scheme.
nlohmann::json stability_curves(const std::vector<const Scheme*>& schemes, const std::vector<double>& orders,
                                int points);

// Those of the page, at the orders of its slider.
nlohmann::json page_stability_curves(const std::vector<const Scheme*>& schemes);

// Every scheme of the list.
std::vector<const Scheme*> all_schemes();

}  // namespace fde
