# SPDX-License-Identifier: MIT
# GNU MPC as MPC::MPC, with the MPFR that it computes with.
find_package(MPFR QUIET)
find_library(MPC_LIBRARY mpc)
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(MPC REQUIRED_VARS MPC_LIBRARY MPFR_FOUND)
if(MPC_FOUND AND NOT TARGET MPC::MPC)
  add_library(MPC::MPC UNKNOWN IMPORTED GLOBAL)
  set_target_properties(MPC::MPC PROPERTIES IMPORTED_LOCATION ${MPC_LIBRARY})
  target_link_libraries(MPC::MPC INTERFACE PkgConfig::MPFR)
endif()
