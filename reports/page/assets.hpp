#pragma once

#include <string_view>

// Files that the page is made of, embedded by assets.S.
namespace fde::assets {

std::string_view page();      // the template with its {{places}}
std::string_view style();     // css
std::string_view charts();    // the specifications of charts
std::string_view script();    // tables, controls, the page itself
std::string_view plot();      // draws a chart without a browser
std::string_view regions();   // of stability, as fde_stability_regions prints them
std::string_view vega();      // vega, vega-lite and vega-embed
std::string_view licences();  // of vega and what it bundles

}  // namespace fde::assets
