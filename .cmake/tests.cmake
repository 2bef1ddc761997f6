# Native build: the GoogleTest programs, the fuzz targets and their seeds, the printer of the tables, and a benchmark.
find_package(GTest REQUIRED)
enable_testing()

file(GLOB test_sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/tests/cpp/*.cpp)
add_executable(warpjet_tests ${test_sources})
target_include_directories(warpjet_tests PRIVATE tests/cpp)
# Tests also parse JSON.
target_include_directories(warpjet_tests SYSTEM PRIVATE ${libraries_folder})
target_link_libraries(warpjet_tests PRIVATE warpjet_detail warpjet_mesh warpjet_source warpjet_core GTest::gtest_main)
# Runs the tests in eight processes, not in one per test: under the sanitizers a process takes longer to start than most tests.
set(shards 8)
foreach(shard RANGE 1 ${shards})
  math(EXPR index "${shard} - 1")
  add_test(NAME tests_${shard}_of_${shards} COMMAND warpjet_tests --gtest_brief=1)
  set_tests_properties(tests_${shard}_of_${shards} PROPERTIES
                       ENVIRONMENT "GTEST_TOTAL_SHARDS=${shards};GTEST_SHARD_INDEX=${index}")
endforeach()

# Compiles a dozen files at once, which takes a third of the time, since most of it is spent on headers. The wasm build compiles
# each file separately, which detects missing includes.
set_target_properties(warpjet_core warpjet_source PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 12)
# Files that include the table of formulas are compiled separately, so that a changed formula recompiles only those.
set_source_files_properties(src/diff/partials.cpp src/emit/lower.cpp src/emit/names.cpp src/ops/ops.cpp src/ops/range.cpp
                            src/ops/spelling.cpp PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
# Names in these files' anonymous namespaces collide with those of others.
set_source_files_properties(src/diff/differentiator.cpp src/diff/combine_terms.cpp src/emit/sums.cpp src/eval/blocks.cpp src/eval/code_writer.cpp
                            src/eval/each_lane.cpp src/eval/idioms.cpp src/eval/machine_code.cpp src/eval/stages.cpp
                            src/frame/separation.cpp src/graph/match.cpp src/ops/interval.cpp src/ops/interval_functions.cpp src/ops/interval_steps.cpp src/graph/print.cpp src/graph/rotations.cpp src/texture/texture.cpp
                            src/warp/orientation.cpp src/warp/polynomial.cpp
                            PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)

# Builds the core once more, with additional rows in a copy of the table of operations; not with the sanitizers.
if(NOT WARPJET_SANITIZE)
  add_executable(own_row_tests ${core_sources} tests/cpp/own_row/own_row_test.cpp)
  target_include_directories(own_row_tests PRIVATE tests/cpp/own_row src tests/cpp)  # in this order
  target_compile_options(own_row_tests PRIVATE -O0)
  set_target_properties(own_row_tests PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 12)
  set_source_files_properties(tests/cpp/own_row/own_row_test.cpp PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
  target_link_libraries(own_row_tests PRIVATE GTest::gtest_main)
  add_test(NAME own_rows COMMAND own_row_tests --gtest_brief=1)
endif()

# With precompiled headers, the tests compile in a third of the time. Not for clang, since ccache can't cache what clang compiles
# with a precompiled header, which costs more time than the headers save.
if(CMAKE_CXX_COMPILER_ID STREQUAL GNU)
  set(common_headers
    <algorithm> <array> <cmath> <cstdint> <functional> <initializer_list> <optional> <span> <string> <string_view>
    <unordered_map> <utility> <vector> <graph/expression.hpp>)
  target_precompile_headers(warpjet_core PRIVATE ${common_headers})
  # Quoted includes would find the headers of the core, without the additional rows.
  target_precompile_headers(own_row_tests PRIVATE ${common_headers})
  target_precompile_headers(warpjet_tests PRIVATE
    <gtest/gtest.h> <algebra/value.hpp> <builder/builder.hpp> <emit/emit.hpp>)
endif()

# Adds a target of `npm run fuzz`. A target runs each given file once, also without libFuzzer, so that the corpus is a test.
function(warpjet_fuzz_target subject library)
  set(name ${subject}_fuzz)
  add_executable(${name} ${ARGN})
  target_include_directories(${name} PRIVATE tests)
  target_include_directories(${name} SYSTEM PRIVATE ${libraries_folder})
  target_link_libraries(${name} PRIVATE ${library})
  if(WARPJET_SANITIZE)
    foreach(target ${name} ${library})
      target_compile_options(${target} PRIVATE -fsanitize=fuzzer-no-link)
    endforeach()
    target_link_options(${name} PRIVATE -fsanitize=fuzzer)
  else()
    target_sources(${name} PRIVATE tests/fuzz/replay.cpp)
  endif()
  file(GLOB corpus CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/tests/fuzz/corpus/${subject}/*)
  add_test(NAME ${subject}_corpus COMMAND ${name} ${corpus})
endfunction()

warpjet_fuzz_target(mesh warpjet_mesh tests/fuzz/mesh_fuzz.cpp tests/fuzz/gltf_mutator.cpp tests/fuzz/limits.cpp)
warpjet_fuzz_target(glsl warpjet_source tests/fuzz/glsl_fuzz.cpp)
warpjet_fuzz_target(wgsl warpjet_source tests/fuzz/wgsl_fuzz.cpp)
warpjet_fuzz_target(graph warpjet_core tests/fuzz/graph_fuzz.cpp tests/fuzz/graph_calls.cpp)

# Writes the seeds of the fuzz targets.
add_executable(fuzz_seeds EXCLUDE_FROM_ALL tests/fuzz/seeds.cpp tests/fuzz/mesh_seeds.cpp tests/fuzz/graph_seeds.cpp)
target_include_directories(fuzz_seeds PRIVATE tests)
target_include_directories(fuzz_seeds SYSTEM PRIVATE ${libraries_folder})
target_link_libraries(fuzz_seeds PRIVATE warpjet_core)

# Prints the tables from which `npm run reference` generates the types and the reference of operations.
add_executable(warpjet_table EXCLUDE_FROM_ALL .scripts/reference/table.cpp)
target_include_directories(warpjet_table PRIVATE js-bindings/wasm)
target_link_libraries(warpjet_table PRIVATE warpjet_mesh warpjet_core)

# The native baseline of `npm run bench:evaluate`.
add_executable(warpjet_bench_evaluate EXCLUDE_FROM_ALL .scripts/bench/evaluate.cpp
               src/eval/blocks.cpp src/eval/each_lane.cpp src/eval/registers.cpp src/graph/schedule.cpp src/ops/ops.cpp src/ops/interval.cpp
               src/ops/interval_functions.cpp src/ops/interval_steps.cpp src/ops/ints.cpp)
target_include_directories(warpjet_bench_evaluate PRIVATE src)
target_compile_options(warpjet_bench_evaluate PRIVATE -Wno-stringop-overflow)  # GCC 12 at -O3 reports a false positive
