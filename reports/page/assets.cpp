// SPDX-License-Identifier: MIT
#include "fdebench/reports/page/assets.hpp"

// The symbols of assets.S for each file: its first byte, and one past its last.
#define FDE_ASSET(id)                                             \
  extern "C" const char fde_asset_##id[], fde_asset_##id##_end[]; \
  std::string_view fde::bench::assets::id() { return {fde_asset_##id, fde_asset_##id##_end}; }

FDE_ASSET(page)
FDE_ASSET(style)
FDE_ASSET(charts)
FDE_ASSET(plot)
FDE_ASSET(regions)
FDE_ASSET(script)
FDE_ASSET(vega)
FDE_ASSET(licences)

#undef FDE_ASSET
