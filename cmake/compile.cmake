# How the targets of the libraries and of the program are compiled.

# Sources are compiled joined, which reads the headers and instantiates the templates that they share once: the more, the
# faster a build from nothing, and the slower one after an edit. Names of one folder must differ even in unnamed
# namespaces.
set(GRIFFITH_JOINED_SOURCES 40 CACHE STRING "Most sources that are compiled as one; 1 compiles each alone")

# Joins the sources of a target in shares of about equal size.
function(griffith_join_sources target)
  get_target_property(sources ${target} SOURCES)
  list(LENGTH sources count)
  math(EXPR shares "(${count} + ${GRIFFITH_JOINED_SOURCES} - 1) / ${GRIFFITH_JOINED_SOURCES}")
  math(EXPR size "(${count} + ${shares} - 1) / ${shares}")
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE ${size})
endfunction()

# The headers that all these targets precompile, once.
add_library(griffith_headers OBJECT ${CMAKE_CURRENT_LIST_DIR}/precompiled.cpp)
target_link_libraries(griffith_headers PRIVATE griffith_compiler Eigen3::Eigen)

# Options that the users of precompiled headers share with them. No function of these targets is replaced by one of another
# library, so calls stay direct and may be inlined even where they end in a shared library.
function(griffith_position_independent target)
  set_target_properties(${target} PROPERTIES POSITION_INDEPENDENT_CODE ON)
  target_compile_options(${target} PRIVATE $<$<CXX_COMPILER_ID:GNU>:-fno-semantic-interposition>)
endfunction()

set(griffith_precompiled_headers
  <algorithm> <array> <cmath> <filesystem> <functional> <map> <memory> <numeric> <optional> <ranges> <span> <string>
  <variant> <vector> <Eigen/Core> <Eigen/Geometry> <Eigen/LU>)
griffith_position_independent(griffith_headers)
# A compiler cache could not keep what is compiled with them.
if(NOT CMAKE_CXX_COMPILER_LAUNCHER)
  target_precompile_headers(griffith_headers PRIVATE ${griffith_precompiled_headers})
endif()

# Compiles a target at a level of optimization: -O3 for what computes, -O2 for what handles meshes and pictures, -O1 for
# what runs seldom or waits for users and files. A level costs a quarter of the time of compiling. The same source gives
# the same bits at each.
function(griffith_compile target level)
  target_link_libraries(${target} PRIVATE $<BUILD_INTERFACE:griffith_compiler>)
  griffith_position_independent(${target})
  target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:${level}>)
  griffith_join_sources(${target})
  if(NOT CMAKE_CXX_COMPILER_LAUNCHER)
    target_precompile_headers(${target} REUSE_FROM griffith_headers)
  endif()
endfunction()
