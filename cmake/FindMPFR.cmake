# SPDX-License-Identifier: MIT
# GNU MPFR as PkgConfig::MPFR.
find_package(PkgConfig QUIET)
if(PKG_CONFIG_FOUND)
  pkg_check_modules(MPFR QUIET IMPORTED_TARGET GLOBAL mpfr)
endif()
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(MPFR REQUIRED_VARS MPFR_LIBRARIES)
