# Native build: one GoogleTest program from all of tests/cpp, and the printer of the tables.
find_package(GTest REQUIRED)
include(GoogleTest)
enable_testing()

file(GLOB test_sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/tests/cpp/*.cpp)
add_executable(warpjet_tests ${test_sources})
target_include_directories(warpjet_tests PRIVATE tests/cpp)
target_link_libraries(warpjet_tests PRIVATE warpjet_mesh warpjet_core GTest::gtest_main)
# Half of the time of compiling them; the wasm build, which has none of it, finds an include that is missing.
target_precompile_headers(warpjet_tests PRIVATE <gtest/gtest.h>)
# PRE_TEST: the list of tests is asked for by ctest, so a crash at start-up is a failing test, not a failing build.
gtest_discover_tests(warpjet_tests DISCOVERY_MODE PRE_TEST)

# What `npm run reference` makes the types and the reference of operations from.
add_executable(warpjet_table EXCLUDE_FROM_ALL .scripts/reference/table.cpp)
target_link_libraries(warpjet_table PRIVATE warpjet_core)

# What `npm run bench:evaluate` compares the wasm with.
add_executable(warpjet_bench_evaluate EXCLUDE_FROM_ALL .scripts/bench/evaluate.cpp
               src/eval/blocks.cpp src/eval/registers.cpp src/graph/schedule.cpp)
target_include_directories(warpjet_bench_evaluate PRIVATE src)
target_compile_options(warpjet_bench_evaluate PRIVATE -Wno-stringop-overflow)  # GCC 12 at -O3 sees one where none can be
