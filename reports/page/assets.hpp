// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

// Files of the page, embedded by assets.S.
namespace fde::bench::assets {

std::string_view page();      // the template with its {{places}}
std::string_view style();     // css
std::string_view charts();    // the specifications of charts
std::string_view script();    // tables, controls, the page itself
std::string_view plot();      // draws a chart without a browser
std::string_view regions();   // stability regions, as printed by fde_page_regions
std::string_view vega();      // vega, vega-lite and vega-embed
std::string_view licences();  // of vega and what it bundles

}  // namespace fde::bench::assets
