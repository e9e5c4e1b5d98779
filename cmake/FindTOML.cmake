# SPDX-License-Identifier: MIT
# toml++, as PkgConfig::TOML.
find_package(PkgConfig QUIET)
if(PKG_CONFIG_FOUND)
  pkg_check_modules(TOML QUIET IMPORTED_TARGET GLOBAL tomlplusplus)
endif()
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(TOML REQUIRED_VARS TOML_LIBRARIES)
