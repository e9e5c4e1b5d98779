# SPDX-License-Identifier: MIT
# The libraries for other projects, as the component `library`: docs/library.md shows how they are taken.
include(CMakePackageConfigHelpers)
include(GNUInstallDirs)
set(cmake_files ${CMAKE_INSTALL_LIBDIR}/cmake/fdebench)

install(TARGETS fde_base fde_problem fde_schemes fde_special_functions fde_reference fde_benchmarks EXPORT fdebench
  ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT library)
install(EXPORT fdebench NAMESPACE fdebench:: FILE fdebench-targets.cmake DESTINATION ${cmake_files} COMPONENT library)

# The public headers, and the headers that they include.
get_property(headers GLOBAL PROPERTY FDEBENCH_PUBLIC_HEADERS)
set(installed "")
while(headers)
  list(POP_FRONT headers header)
  list(APPEND installed ${header})
  file(STRINGS ${PROJECT_SOURCE_DIR}/${header} includes REGEX "^#include \"fdebench/")
  list(TRANSFORM includes REPLACE "#include \"fdebench/([^\"]+)\".*" "\\1")
  list(APPEND headers ${includes})
  list(REMOVE_ITEM headers ${installed})
  get_filename_component(folder ${header} DIRECTORY)
  install(FILES ${PROJECT_SOURCE_DIR}/${header} DESTINATION include/fdebench/${folder} COMPONENT library)
endwhile()
install(FILES ${PROJECT_SOURCE_DIR}/benchmarks/fdebench.hpp DESTINATION include/fdebench COMPONENT library)
set_property(GLOBAL PROPERTY FDEBENCH_INSTALLED_HEADERS ${installed})

configure_package_config_file(cmake/fdebench-config.cmake.in ${PROJECT_BINARY_DIR}/fdebench-config.cmake
  INSTALL_DESTINATION ${cmake_files})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/fdebench-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/fdebench-config.cmake ${PROJECT_BINARY_DIR}/fdebench-config-version.cmake
  cmake/FindMPC.cmake cmake/FindMPFR.cmake cmake/FindTOML.cmake DESTINATION ${cmake_files} COMPONENT library)

# The libraries are static, so what they link is named with them. The alignment is part of how objects are laid out.
get_target_property(alignment fde_base INTERFACE_COMPILE_DEFINITIONS)
function(install_pkg_config name what needs libraries)
  set(file ${PROJECT_BINARY_DIR}/fdebench-${name}.pc)
  configure_file(${PROJECT_SOURCE_DIR}/cmake/fdebench.pc.in ${file} @ONLY)
  install(FILES ${file} DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig COMPONENT library)
endfunction()
install_pkg_config(schemes "Schemes for fractional differential equations" "eigen3 fmt"
  "-lfde_schemes -lfde_problem -lfde_base")
install_pkg_config(special_functions "Mittag-Leffler functions, of matrices too, and Prabhakar's function"
  "eigen3 fmt mpfr" "-lfde_special_functions -lfde_base -lmpc")
install_pkg_config(reference "References for fractional differential equations"
  fdebench-special_functions "-lfde_reference -lfde_problem -lfde_special_functions -lfde_base")
if(TARGET asmjit::asmjit)
  set(machine_code " -lasmjit -lpthread -lrt")
endif()
install_pkg_config(benchmarks "Scenes, measures and the search for the cheapest scheme"
  "fdebench-schemes fdebench-reference libcrypto tomlplusplus" "-lfde_benchmarks${machine_code}")
