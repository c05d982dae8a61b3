# cmake -DEXPECTED= -DSCENE= -DCOMMAND= -P same_state.cmake: runs a program on a scene; the last line that it prints is to
# be that of EXPECTED.
string(REPLACE "|" ";" command "${COMMAND}")
execute_process(COMMAND ${EXPECTED} ${SCENE} OUTPUT_VARIABLE expected COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${command} ${SCENE} OUTPUT_VARIABLE output COMMAND_ERROR_IS_FATAL ANY)
string(REGEX MATCH "[^\n]*\n$" last "${output}")
if(NOT last STREQUAL expected)
  message(FATAL_ERROR "${command} printed\n${output}whose last line is not\n${expected}")
endif()
