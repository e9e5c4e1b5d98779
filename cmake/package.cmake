# SPDX-License-Identifier: MIT
# Packages of what has been built, for machines without a compiler (docs/install.md): those of Debian, one for each component of
# the installation, an archive and a wheel. The target `packages` makes all of them.
get_cmake_property(components COMPONENTS)
list(REMOVE_ITEM components Unspecified wheel)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME fdebench)
set(CPACK_DEBIAN_RUNTIME_PACKAGE_NAME libfdebench0)
set(CPACK_DEBIAN_LIBRARY_PACKAGE_NAME libfdebench-dev)
set(CPACK_DEBIAN_DATA_PACKAGE_NAME fdebench-data)
set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-fdebench)

include(cmake/copyright.cmake)
foreach(component ${components})
  string(TOUPPER ${component} id)
  install(FILES ${fde_copyright} DESTINATION share/doc/${CPACK_DEBIAN_${id}_PACKAGE_NAME} RENAME copyright COMPONENT ${component})
endforeach()
find_program(PATCHELF patchelf)
if(NOT PATCHELF OR NOT fde_copyright_complete)
  message(STATUS "No packages: ./setup.sh --tests installs what they need")
  return()
endif()
configure_file(cmake/bundle.cmake.in ${PROJECT_BINARY_DIR}/bundle.cmake @ONLY)

# The archive: the components `program` and `data`, and every library but those of glibc.
install(CODE "
  include(\"${PROJECT_BINARY_DIR}/bundle.cmake\")
  foreach(component program data)
    execute_process(COMMAND \"${CMAKE_COMMAND}\" --install \"${PROJECT_BINARY_DIR}\" --prefix \"\${CMAKE_INSTALL_PREFIX}\"
      --component \${component} --strip COMMAND_ERROR_IS_FATAL ANY OUTPUT_QUIET)
  endforeach()
  fde_bundle(\"\${CMAKE_INSTALL_PREFIX}/bin/fdebench\" \"\${CMAKE_INSTALL_PREFIX}/lib/fdebench\" \"\\\$ORIGIN/../lib/fdebench\"
    \"ld-linux.*|lib(c|m)\" NO)
  fde_licences(\"\${CMAKE_INSTALL_PREFIX}/share/doc/fdebench/licences\" \"\${fde_bundled}\")
  " COMPONENT portable EXCLUDE_FROM_ALL)

set(FDEBENCH_PACKAGER "the fdebench authors <fdebench@localhost>" CACHE STRING "Maintainer of Debian's packages: NAME <ADDRESS>")
set(CPACK_GENERATOR DEB TGZ)
set(CPACK_PROJECT_CONFIG_FILE ${PROJECT_SOURCE_DIR}/cmake/package_of_generator.cmake)
set(CPACK_PACKAGE_CONTACT ${FDEBENCH_PACKAGER})
set(CPACK_PACKAGE_FILE_NAME fdebench-${PROJECT_VERSION}-linux-${CMAKE_SYSTEM_PROCESSOR})
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ
  WORLD_EXECUTE)
set(CPACK_COMPONENTS_ALL ${components})
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
# Not of the components without binaries: cpack would look into each of their files.
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_LIBRARY_PACKAGE_SHLIBDEPS OFF)
set(CPACK_DEBIAN_DATA_PACKAGE_SHLIBDEPS OFF)
set(CPACK_DEBIAN_PACKAGE_SECTION math)

set(CPACK_COMPONENT_PROGRAM_DESCRIPTION "solvers of fractional differential equations, measured
Solves equations with fractional derivatives by many schemes, measures their
error against run time, and chooses the cheapest scheme for an accuracy.")
set(CPACK_DEBIAN_PROGRAM_PACKAGE_RECOMMENDS "nodejs, librsvg2-bin, fonts-urw-base35")
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SUGGESTS "fdebench-data")
set(CPACK_COMPONENT_RUNTIME_DESCRIPTION "solvers of fractional differential equations: library for C
The shared library to which programs in C, Fortran and others are linked.")
set(CPACK_DEBIAN_RUNTIME_PACKAGE_SECTION libs)
set(CPACK_COMPONENT_LIBRARY_DESCRIPTION "solvers of fractional differential equations: development
Static libraries, headers, and the files of CMake and pkg-config.")
set(CPACK_DEBIAN_LIBRARY_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_LIBRARY_PACKAGE_DEPENDS
  "libeigen3-dev, libfmt-dev, libmpfr-dev, libmpc-dev, libssl-dev, libtomlplusplus-dev")
if(TARGET asmjit::asmjit)
  string(APPEND CPACK_DEBIAN_LIBRARY_PACKAGE_DEPENDS ", libasmjit-dev")
endif()
if("runtime" IN_LIST components)
  get_target_property(abi fde_c SOVERSION)
  file(WRITE ${PROJECT_BINARY_DIR}/shlibs "libfdebench ${abi} libfdebench${abi} (= ${PROJECT_VERSION})\n")
  set(CPACK_DEBIAN_RUNTIME_PACKAGE_CONTROL_EXTRA ${PROJECT_BINARY_DIR}/shlibs)
  string(APPEND CPACK_DEBIAN_LIBRARY_PACKAGE_DEPENDS ", libfdebench0 (= ${PROJECT_VERSION})")
endif()
set(CPACK_COMPONENT_DATA_DESCRIPTION "reference values for fractional differential equations
Tables of Mittag-Leffler functions, trajectories and errors, with bounds.")
set(CPACK_DEBIAN_DATA_PACKAGE_ARCHITECTURE all)
if(TARGET fde_python)
  set(CPACK_COMPONENT_PYTHON_DESCRIPTION "solvers of fractional differential equations: Python module
Solves scenes and equations of your own, and chooses the cheapest scheme.")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
  math(EXPR next "${Python_VERSION_MINOR} + 1")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS "python3 (>= 3.${Python_VERSION_MINOR}), python3 (<< 3.${next}), python3-numpy")
endif()
# Nothing is built for it: the target `packages` has built what is installed.
set(CMAKE_SKIP_INSTALL_ALL_DEPENDENCY ON)
include(CPack)

set(packages ${PROJECT_BINARY_DIR}/packages)
if(TARGET fde_python)
  set(wheel COMMAND ${CMAKE_COMMAND} -E env FDEBENCH_BUILD=${PROJECT_BINARY_DIR} ${Python_EXECUTABLE} -m pip wheel --quiet --no-deps
    --no-build-isolation --no-index --wheel-dir ${packages} ${PROJECT_SOURCE_DIR}/python)
endif()
add_custom_target(packages
  COMMAND ${CMAKE_COMMAND} -E rm -rf ${packages}
  COMMAND ${CMAKE_CPACK_COMMAND} --config ${PROJECT_BINARY_DIR}/CPackConfig.cmake -B ${packages}
  COMMAND ${CMAKE_COMMAND} -E rm -rf ${packages}/_CPack_Packages
  ${wheel}
  COMMAND sh -c "cd ${packages} && sha256sum *.* > SHA256SUMS"
  USES_TERMINAL VERBATIM)
add_dependencies(packages fdebench fde_benchmarks)
foreach(target fde_python fde_c man)
  if(TARGET ${target})
    add_dependencies(packages ${target})
  endif()
endforeach()
