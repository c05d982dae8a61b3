# Without -ffp-contract=off kept by all passes of the compiler, builds differ in the last bit: GCC 12 makes products with
# alternating sums of straight-line code that it vectorizes.
execute_process(COMMAND ${OBJDUMP} --disassemble --no-show-raw-insn ${LIBRARY} COMMAND grep -E -c "vfmaddsub|vfmsubadd"
                OUTPUT_VARIABLE count OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_VARIABLE problem
                RESULTS_VARIABLE results)
if(NOT results MATCHES "^0;" OR NOT count STREQUAL "0")
  message(FATAL_ERROR "${LIBRARY}: '${count}' fused products with alternating sums ${problem}")
endif()
