# SPDX-License-Identifier: MIT
# Each package of Debian has a changelog in Debian's form. Read by cpack before it makes the packages.
file(STRINGS ${CMAKE_CURRENT_LIST_DIR}/../CITATION.cff date REGEX "^date-released: ")
string(REPLACE "date-released: " "" date "${date}")
execute_process(COMMAND date --utc --rfc-email --date=${date} OUTPUT_VARIABLE date OUTPUT_STRIP_TRAILING_WHITESPACE
  COMMAND_ERROR_IS_FATAL ANY)
foreach(component ${CPACK_COMPONENTS_ALL})
  string(TOUPPER ${component} id)
  set(package ${CPACK_DEBIAN_${id}_PACKAGE_NAME})
  set(changelog ${CPACK_TEMPORARY_DIRECTORY}/${component}/usr/share/doc/${package}/changelog)
  file(WRITE ${changelog} "${package} (${CPACK_PACKAGE_VERSION}) unstable; urgency=low

  * CHANGELOG.md of the sources lists the changes.

 -- ${CPACK_PACKAGE_CONTACT}  ${date}
")
  execute_process(COMMAND gzip --best --no-name ${changelog} COMMAND_ERROR_IS_FATAL ANY)
endforeach()
