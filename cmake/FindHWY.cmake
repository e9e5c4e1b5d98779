# SPDX-License-Identifier: MIT
# The headers of Highway, as HWY::headers. Its library is not linked: schemes/problem/processor/vector_targets.cpp.
find_path(HWY_INCLUDE_DIR hwy/highway.h)
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(HWY REQUIRED_VARS HWY_INCLUDE_DIR)
if(HWY_FOUND AND NOT TARGET HWY::headers)
  add_library(HWY::headers INTERFACE IMPORTED GLOBAL)
  target_include_directories(HWY::headers INTERFACE ${HWY_INCLUDE_DIR})
endif()
