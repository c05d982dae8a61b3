# The example as its folder has it, with no flags.
cmake_minimum_required(VERSION 3.25)
include(${CMAKE_CURRENT_LIST_DIR}/run.cmake)
build_project(${SOURCE}/examples/hello ${WORK}/hello)
run(${EXPECTED})
file(WRITE ${WORK}/expected.txt "${output}")
expect_same_run(${WORK}/hello/hello)
# The program of README.md breaks a pane.
execute_process(COMMAND ${WORK}/hello/shot WORKING_DIRECTORY ${SOURCE} OUTPUT_VARIABLE masses COMMAND_ERROR_IS_FATAL ANY)
string(REGEX MATCHALL "kg" pieces "${masses}")
list(LENGTH pieces count)
if(count LESS 2)
  message(SEND_ERROR "nothing broke:\n${masses}")
endif()
