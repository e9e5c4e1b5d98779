# SPDX-License-Identifier: MIT
# The first Python that has these packages, in the variable `found`; not set where none has.
function(find_python_with packages found)
  list(JOIN packages ", " names)
  foreach(python python3 /usr/bin/python3)
    execute_process(COMMAND ${python} -c "import sys, ${names}; print(sys.executable)" RESULT_VARIABLE missing
      OUTPUT_VARIABLE executable OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
    if(missing STREQUAL "0")
      set(${found} ${executable} PARENT_SCOPE)
      return()
    endif()
  endforeach()
  message(STATUS "No Python has ${names}: ./setup.sh --tests installs them")
endfunction()
