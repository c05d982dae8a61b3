# Runs a command, whose output becomes the variable `output`; a failure ends the test.
macro(run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE exit_code OUTPUT_VARIABLE output ERROR_VARIABLE errors)
  if(NOT exit_code EQUAL 0)
    message(FATAL_ERROR "${ARGN}\nended with ${exit_code}\n${output}${errors}")
  endif()
endmacro()

# Builds the project in `folder` against the package, with these arguments for CMake.
function(build_project folder build)
  file(REMOVE_RECURSE ${build})
  run(${CMAKE_COMMAND} -G ${GENERATOR} -S ${folder} -B ${build} -DCMAKE_PREFIX_PATH=${PREFIX} -DCMAKE_CXX_COMPILER=${CXX}
      ${ARGN})
  run(${CMAKE_COMMAND} --build ${build})
endfunction()

# The program prints what the example prints when it has the flags of the library, and its wall breaks.
function(expect_same_run program)
  file(READ ${WORK}/expected.txt expected)
  run(${program})
  if(NOT output STREQUAL expected)
    message(SEND_ERROR "${program} printed\n${output}instead of\n${expected}")
  endif()
  string(REGEX MATCH "([0-9]+) pieces" pieces "${output}")
  if(NOT CMAKE_MATCH_1 GREATER 1)
    message(SEND_ERROR "nothing broke:\n${output}")
  endif()
endfunction()
