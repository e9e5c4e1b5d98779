# SPDX-License-Identifier: MIT
# Highway, as PkgConfig::HWY.
find_package(PkgConfig QUIET)
if(PKG_CONFIG_FOUND)
  pkg_check_modules(HWY QUIET IMPORTED_TARGET GLOBAL libhwy)
endif()
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(HWY REQUIRED_VARS HWY_LIBRARIES)
