# What `cmake --install` puts where: the libraries as a CMake package and for pkg-config, and the programs.
include(CMakePackageConfigHelpers)
set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/griffith)
file(RELATIVE_PATH prefix_from_pc /${CMAKE_INSTALL_LIBDIR}/pkgconfig /)

# One export a component of find_package(), so that the simulation asks for no graphics.
function(griffith_install_library name)
  install(TARGETS griffith_${name} ${ARGN} EXPORT griffith-${name}
          FILE_SET HEADERS DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/griffith)
  install(EXPORT griffith-${name} NAMESPACE griffith:: DESTINATION ${package_folder})
endfunction()

set_target_properties(griffith_surface_reader PROPERTIES EXPORT_NAME surface_reader)
griffith_install_library(sim griffith_surface_reader)
if(GRIFFITH_BUILD_RENDERER)
  griffith_install_library(renderer)
endif()
if(GRIFFITH_BUILD_BINDINGS)
  griffith_install_library(c)
  configure_file(cmake/griffith-c.pc.in griffith-c.pc @ONLY)
  install(FILES ${PROJECT_BINARY_DIR}/griffith-c.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
endif()
if(GRIFFITH_BUILD_EDITOR)
  install(TARGETS griffith)
endif()

configure_package_config_file(cmake/griffith-config.cmake.in griffith-config.cmake INSTALL_DESTINATION ${package_folder})
# Until version 1.0 every minor version may change what others compile against.
write_basic_package_version_file(griffith-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/griffith-config.cmake ${PROJECT_BINARY_DIR}/griffith-config-version.cmake
              ${PROJECT_SOURCE_DIR}/cmake/FindVoro.cmake DESTINATION ${package_folder})
install(FILES ${griffith_public_headers} ${PROJECT_BINARY_DIR}/include/griffith/version.h
        DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/griffith)

list(JOIN griffith_bullet_LDFLAGS " " bullet_libraries)
configure_file(cmake/griffith.pc.in griffith.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/griffith.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
