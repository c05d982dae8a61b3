# A program that works with Eigen itself: none of its copies of Eigen's functions may take the place of the library's.
cmake_minimum_required(VERSION 3.25)
include(${CMAKE_CURRENT_LIST_DIR}/run.cmake)
# The example is compiled already, with no flags either.
build_project(${CMAKE_CURRENT_LIST_DIR}/neighbor ${WORK}/neighbor
              -DHELLO_OBJECT=${WORK}/hello/CMakeFiles/hello.dir/main.cpp.o)
expect_same_run(${WORK}/neighbor/neighbor)
