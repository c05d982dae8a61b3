# What the libraries for other programs have in common.

# <griffith/world.h> and all else without an installation too.
configure_file(${CMAKE_CURRENT_LIST_DIR}/version.h.in ${PROJECT_BINARY_DIR}/include/griffith/version.h @ONLY)
foreach(folder sim renderer)
  file(CREATE_LINK ${PROJECT_SOURCE_DIR}/${folder} ${PROJECT_BINARY_DIR}/include/griffith/${folder} SYMBOLIC)
endforeach()
set(griffith_public_headers errors.h frame.h material.h mesh.h recording.h scene.h world.h)
list(TRANSFORM griffith_public_headers PREPEND ${PROJECT_SOURCE_DIR}/include/griffith/)
foreach(header ${griffith_public_headers})
  get_filename_component(name ${header} NAME)
  file(CREATE_LINK ${header} ${PROJECT_BINARY_DIR}/include/griffith/${name} SYMBOLIC)
endforeach()

# A static library that other programs may link as griffith::<name>. HEADERS, relative to the project's folder, are
# those that they may include; they need no library but Eigen.
function(griffith_library name)
  cmake_parse_arguments(ARG "" "" "HEADERS" ${ARGN})
  set(target griffith_${name})
  list(TRANSFORM ARG_HEADERS PREPEND ${PROJECT_SOURCE_DIR}/)
  add_library(${target} STATIC)
  add_library(griffith::${name} ALIAS ${target})
  target_sources(${target} PUBLIC FILE_SET HEADERS BASE_DIRS ${PROJECT_SOURCE_DIR} FILES ${ARG_HEADERS})
  set_target_properties(${target} PROPERTIES EXPORT_NAME ${name} LINKER_LANGUAGE CXX)
  target_compile_features(${target} PUBLIC cxx_std_20)
  # Those who link it write <griffith/world.h>; the headers themselves say "sim/...".
  target_include_directories(${target} PUBLIC $<BUILD_INTERFACE:${PROJECT_BINARY_DIR}/include>
                                              $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
  target_link_libraries(${target} PUBLIC Eigen3::Eigen)
  griffith_keep_own_copies(${target})
endfunction()

# A folder of the library griffith_<library>: a target griffith_<library>_<folder> of its own, compiled at one level of
# optimization. LIBRARIES are those whose headers it may include.
function(griffith_folder library folder level)
  cmake_parse_arguments(ARG "" "" "LIBRARIES;SOURCES" ${ARGN})
  set(target griffith_${library}_${folder})
  add_library(${target} OBJECT ${ARG_SOURCES})
  target_link_libraries(${target} PRIVATE Eigen3::Eigen ${ARG_LIBRARIES})
  griffith_compile(${target} ${level})
  target_sources(griffith_${library} PRIVATE $<TARGET_OBJECTS:${target}>)
endfunction()

# The linker takes one copy of each inline function, of this library or of the program that links it. Theirs may be
# compiled for another instruction set, with other rounding or another alignment of Eigen's allocations. So all objects
# become one, in which such copies are local. Sanitizers compare addresses of such copies and stay without.
function(griffith_keep_own_copies target)
  if(GRIFFITH_SANITIZERS)
    return()
  endif()
  add_custom_command(TARGET ${target} POST_BUILD VERBATIM
    COMMAND ${CMAKE_COMMAND} -DARCHIVE=$<TARGET_FILE:${target}> -DLINKER=${CMAKE_LINKER} -DNM=${CMAKE_NM}
            -DOBJCOPY=${CMAKE_OBJCOPY} -DAR=${CMAKE_AR} -P ${PROJECT_SOURCE_DIR}/cmake/keep_own_copies.cmake)
endfunction()
