# `cmake --build --preset release --target tidy`: names and habits, as .clang-tidy has them. Takes some minutes.
find_program(GRIFFITH_RUN_CLANG_TIDY NAMES run-clang-tidy-14 run-clang-tidy DOC "Checks names and habits")
mark_as_advanced(GRIFFITH_RUN_CLANG_TIDY)
if(GRIFFITH_RUN_CLANG_TIDY)
  # Clang does not know all options of GCC.
  add_custom_target(tidy VERBATIM
    COMMAND ${CMAKE_COMMAND} -E make_directory ${PROJECT_BINARY_DIR}/tidy
    COMMAND sed "s/-fno-gnu-unique//g; s/-Wno-[a-z-]*//g; s/-Werror//g" ${PROJECT_BINARY_DIR}/compile_commands.json
            > ${PROJECT_BINARY_DIR}/tidy/compile_commands.json
    COMMAND ${GRIFFITH_RUN_CLANG_TIDY} -quiet -p ${PROJECT_BINARY_DIR}/tidy "/(sim|renderer|ui|app)/CMakeFiles/"
    WORKING_DIRECTORY ${PROJECT_SOURCE_DIR})
endif()
