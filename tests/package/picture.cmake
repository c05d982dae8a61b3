# A program that draws with griffith::renderer.
cmake_minimum_required(VERSION 3.25)
include(${CMAKE_CURRENT_LIST_DIR}/run.cmake)
build_project(${CMAKE_CURRENT_LIST_DIR}/picture ${WORK}/picture)
run(${WORK}/picture/picture)
if(NOT output STREQUAL "id 7\n")
  message(SEND_ERROR "in the middle of the picture is ${output}")
endif()
