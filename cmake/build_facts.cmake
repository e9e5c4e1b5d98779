# SPDX-License-Identifier: MIT
# Run at every build: writes build_facts.hpp anew only when a fact has changed, so nothing else is rebuilt.
execute_process(COMMAND git describe --always --dirty --abbrev=12 WORKING_DIRECTORY ${SOURCE_DIR}
  OUTPUT_VARIABLE COMMIT OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
if(NOT COMMIT)
  set(COMMIT "unknown")
endif()
configure_file(${SOURCE_DIR}/cmake/build_facts.hpp.in ${OUTPUT} @ONLY)
