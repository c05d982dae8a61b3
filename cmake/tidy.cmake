# `cmake --build --preset release --target tidy`: names and habits, as .clang-tidy has them. Takes some minutes, and
# clang-tidy 15 or newer: older ones do not understand the standard library's ranges.
find_program(GRIFFITH_RUN_CLANG_TIDY NAMES run-clang-tidy-19 run-clang-tidy-16 run-clang-tidy-15 DOC "Checks names and habits")
find_program(GRIFFITH_CLANG_TIDY NAMES clang-tidy-19 clang-tidy-16 clang-tidy-15 DOC "What it runs")
mark_as_advanced(GRIFFITH_RUN_CLANG_TIDY GRIFFITH_CLANG_TIDY)
if(GRIFFITH_RUN_CLANG_TIDY AND GRIFFITH_CLANG_TIDY)
  # Clang does not know all options of GCC.
  add_custom_target(tidy VERBATIM
    COMMAND ${CMAKE_COMMAND} -E make_directory ${PROJECT_BINARY_DIR}/tidy
    COMMAND sed "s/-fno-gnu-unique//g; s/-Wno-[a-z-]*//g; s/-Werror//g; s/-Winvalid-pch//g"
            ${PROJECT_BINARY_DIR}/compile_commands.json > ${PROJECT_BINARY_DIR}/tidy/compile_commands.json
    COMMAND ${GRIFFITH_RUN_CLANG_TIDY} -quiet -clang-tidy-binary ${GRIFFITH_CLANG_TIDY} -p ${PROJECT_BINARY_DIR}/tidy
            -header-filter "${PROJECT_SOURCE_DIR}/(sim|renderer|ui|app)/.*" "/(sim|renderer|ui|app)/CMakeFiles/griffith_"
    WORKING_DIRECTORY ${PROJECT_SOURCE_DIR})
endif()
