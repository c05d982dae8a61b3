# A program that works with Eigen itself: none of its copies of Eigen's functions may take the place of the library's.
cmake_minimum_required(VERSION 3.25)
include(${CMAKE_CURRENT_LIST_DIR}/run.cmake)
build_project(${CMAKE_CURRENT_LIST_DIR}/neighbor ${WORK}/neighbor)
expect_same_run(${WORK}/neighbor/neighbor)
