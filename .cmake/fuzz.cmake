# Fuzz build (clang): the targets that `npm run fuzz` runs, and the program that writes their seeds.
target_compile_definitions(warpjet_mesh PUBLIC FUZZING_BUILD_MODE_UNSAFE_FOR_PRODUCTION)  # smaller limits

function(warpjet_fuzz_program name)
  add_executable(${name} ${ARGN})
  target_include_directories(${name} PRIVATE tests)
  # Tests read JSON too.
  target_include_directories(${name} SYSTEM PRIVATE ${libraries_folder})
endfunction()

warpjet_fuzz_program(mesh_fuzz tests/fuzz/mesh_fuzz.cpp tests/fuzz/gltf_mutator.cpp)
target_link_libraries(mesh_fuzz PRIVATE warpjet_mesh)

warpjet_fuzz_program(graph_fuzz tests/fuzz/graph_fuzz.cpp tests/fuzz/graph_calls.cpp)
target_link_libraries(graph_fuzz PRIVATE warpjet_core)

foreach(name mesh_fuzz graph_fuzz)
  target_link_options(${name} PRIVATE -fsanitize=fuzzer)
endforeach()

warpjet_fuzz_program(fuzz_seeds EXCLUDE_FROM_ALL tests/fuzz/seeds.cpp
                     tests/fuzz/mesh_seeds.cpp tests/fuzz/graph_seeds.cpp)
target_link_libraries(fuzz_seeds PRIVATE warpjet_core)
target_link_options(fuzz_seeds PRIVATE -fsanitize=fuzzer-no-link)
