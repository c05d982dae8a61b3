# The compiler alone, with what pkg-config says and flags that round otherwise than those of the library.
cmake_minimum_required(VERSION 3.25)
include(${CMAKE_CURRENT_LIST_DIR}/run.cmake)
file(GLOB folder ${PREFIX}/lib*/pkgconfig ${PREFIX}/lib/*/pkgconfig)
set(ENV{PKG_CONFIG_PATH} ${folder})
run(pkg-config --cflags --libs griffith)
separate_arguments(flags UNIX_COMMAND "${output}")
run(${CXX} -std=c++20 -O3 -march=native -ffp-contract=fast ${SOURCE}/examples/hello/main.cpp -o ${WORK}/hello_by_hand ${flags})
expect_same_run(${WORK}/hello_by_hand)
