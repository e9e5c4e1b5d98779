# SPDX-License-Identifier: MIT
# Writes the manual pages of PROGRAM to the folder MAN and the completions of shells to COMPLETIONS.
function(print file)
  execute_process(COMMAND ${PROGRAM} ${ARGN} OUTPUT_FILE ${file} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

file(REMOVE_RECURSE ${MAN} ${COMPLETIONS})
file(MAKE_DIRECTORY ${MAN} ${COMPLETIONS})
execute_process(COMMAND ${PROGRAM} __complete "" OUTPUT_VARIABLE commands COMMAND_ERROR_IS_FATAL ANY)
string(REGEX MATCHALL "(^|\n)[a-z][a-z-]*" commands "${commands}")
foreach(command ${commands})
  string(STRIP "${command}" command)
  print(${MAN}/fdebench-${command}.1 help --man ${command})
endforeach()
print(${COMPLETIONS}/fdebench completion bash)
print(${COMPLETIONS}/_fdebench completion zsh)
print(${COMPLETIONS}/fdebench.fish completion fish)
print(${MAN}/fdebench.1 help --man)
