// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "fdebench/schemes/stepping/scheme.hpp"

namespace fde::bench {

// Boundaries of the linear stability regions for charts: `orders`, and `curves`: by scheme id and order the
// pieces of region_boundary() in the upper half plane of z = lambda h^order, each piece as [re, im, re, im,
// ...]; null if the scheme does not accept the order. Schemes without a symbol are left out. `same` maps a
// scheme whose curves all equal an earlier scheme's to that scheme's id. `points` is the number per curve,
// doubled for implicit schemes.
nlohmann::json stability_curves(const std::vector<const Scheme*>& schemes, const std::vector<double>& orders,
                                int points);

// The curves of the page, for the orders of its slider.
nlohmann::json page_stability_curves(const std::vector<const Scheme*>& schemes);

// Every scheme of the list.
std::vector<const Scheme*> all_schemes();

}  // namespace fde::bench
