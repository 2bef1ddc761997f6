# WebAssembly build: for each module NAME.wasm, which .scripts/build.mjs inlines, and for the mesh's mesh.mjs, a factory.
#   core        the compiler; no SIMD, so that it runs wherever WebAssembly does
#   evaluation  programs over many vertices
#   mesh        files of meshes, and what is done to meshes
#   glsl        shader text as a list of the core's operations

# Everything is compiled with CMake's -O3 (Release), but for what runs once per glTF file: checks of its JSON, which nobody waits
# for. The core at -Oz took 2.8 times as long for a warp of 3,000 nodes, and saved 40 KB gzipped.
set_source_files_properties(
  src/mesh/gltf/container.cpp src/mesh/gltf/export.cpp src/mesh/gltf/gltf.cpp src/mesh/load.cpp src/mesh/gltf/look.cpp
  src/mesh/gltf/scene.cpp src/mesh/gltf/schema.cpp src/mesh/sentences.cpp src/mesh/gltf/tinygltf.cpp src/mesh/gltf/uri.cpp
  TARGET_DIRECTORY warpjet_mesh PROPERTIES COMPILE_OPTIONS -Oz)

# Or clang would make exp2 of pow(2, x), which JavaScript's Math lacks.
set_property(SOURCE src/ops/ops.cpp src/ops/interval.cpp src/ops/interval_functions.cpp src/ops/interval_steps.cpp TARGET_DIRECTORY warpjet_core APPEND PROPERTY COMPILE_OPTIONS -fno-builtin)

# What computes four vertices at a time. The core links none of it, for link-time optimisation would give SIMD to all
# functions of a module that has one with it.
set_source_files_properties(js-bindings/wasm/evaluation.cpp PROPERTIES COMPILE_OPTIONS -msimd128)
set_source_files_properties(
  src/eval/blocks.cpp src/eval/code_writer.cpp src/eval/each_lane.cpp src/eval/machine_code.cpp src/eval/stages.cpp
  TARGET_DIRECTORY warpjet_core PROPERTIES COMPILE_OPTIONS -msimd128)

# emcc renamed the setting in 3.1.25. No function calls itself over nodes, so the stack can be small.
if(EMSCRIPTEN_VERSION VERSION_LESS 3.1.25)
  set(stack_setting TOTAL_STACK)
else()
  set(stack_setting STACK_SIZE)
endif()

# warpjet_module(NAME SUFFIX SOURCE): what all of them have in common.
function(warpjet_module name suffix source)
  set(target warpjet_${name}_wasm)
  add_executable(${target} ${source})
  set_target_properties(${target} PROPERTIES OUTPUT_NAME ${name} SUFFIX ${suffix})
  target_link_options(${target} PRIVATE
    -flto                                 # see CMakeLists.txt
    --no-entry                            # a library: there is no main()
    -sALLOW_MEMORY_GROWTH                 # graphs and meshes of any size
    -sSUPPORT_ERRNO=0                     # nothing reads it
    -sFILESYSTEM=0)                       # nothing reads files
endfunction()

# Two that need none of Emscripten's JavaScript: js-bindings/wasm/start.ts has the little that they import. No exception crosses
# the border: a throw that is left in the code does not link.
warpjet_module(core .wasm js-bindings/wasm/core.cpp)
warpjet_module(evaluation .wasm js-bindings/wasm/evaluation.cpp)
foreach(target warpjet_core_wasm warpjet_evaluation_wasm)
  target_link_libraries(${target} PRIVATE warpjet_core)
  target_compile_options(${target} PRIVATE -fno-exceptions -fno-rtti)
  target_link_options(${target} PRIVATE
    -fno-exceptions
    -sMALLOC=emmalloc                     # the smallest allocator that frees
    -sINITIAL_MEMORY=2MB                  # a page that warps one mesh needs no more
    -s${stack_setting}=262144
    -sJS_MATH                             # C's mathematics, from JavaScript: 20 KB less than musl's, tables that do not pack
    -sWARN_ON_UNDEFINED_SYMBOLS=0         # which that leaves
    -sERROR_ON_UNDEFINED_SYMBOLS=0)
endforeach()
target_compile_options(warpjet_core PRIVATE -fno-rtti)
target_link_options(warpjet_core_wasm PRIVATE
  "SHELL:-Xlinker --features=mutable-globals,sign-ext,bulk-memory,bulk-memory-opt,multivalue,reference-types,nontrapping-fptoint,call-indirect-overlong")  # not simd128: it does not link if it got in

# A text nests as deep as the parser lets it, and each level takes less than 1 KB.
warpjet_module(glsl .wasm js-bindings/wasm/glsl.cpp)
target_link_libraries(warpjet_glsl_wasm PRIVATE warpjet_glsl)
target_compile_options(warpjet_glsl_wasm PRIVATE -fno-exceptions -fno-rtti)
target_link_options(warpjet_glsl_wasm PRIVATE
  -fno-exceptions
  -sMALLOC=emmalloc
  -sINITIAL_MEMORY=2MB
  -s${stack_setting}=1048576
  -Wl,--stack-first
  "SHELL:-Xlinker --features=mutable-globals,sign-ext,bulk-memory,bulk-memory-opt,multivalue,reference-types,nontrapping-fptoint,call-indirect-overlong"
  -sJS_MATH
  -sWARN_ON_UNDEFINED_SYMBOLS=0
  -sERROR_ON_UNDEFINED_SYMBOLS=0)

# A file that lies may ask for any amount of memory and nest as deep as it likes. tinygltf and its JSON parser throw;
# js-bindings/wasm/mesh.cpp catches everything.
warpjet_module(mesh .mjs js-bindings/wasm/mesh.cpp)
target_link_libraries(warpjet_mesh_wasm PRIVATE warpjet_mesh warpjet_core)
set_target_properties(warpjet_mesh_wasm PROPERTIES LINK_DEPENDS ${PROJECT_SOURCE_DIR}/.cmake/mesh.js)
target_compile_options(warpjet_mesh_wasm PRIVATE -fwasm-exceptions)
target_compile_options(warpjet_mesh PRIVATE -fwasm-exceptions)
target_link_options(warpjet_mesh_wasm PRIVATE
  --js-library ${PROJECT_SOURCE_DIR}/.cmake/mesh.js
  -sMODULARIZE                            # a factory: nothing happens at import, nothing global
  -sEXPORT_ES6                            # `export default factory`, for the bundler
  -sENVIRONMENT=web                       # the glue for Node does not run as an ES module in 3.1.6; with the bytes handed in, this one runs in both
  -sWASM_ASYNC_COMPILATION=0              # the factory returns the module itself, no promise
  -sDYNAMIC_EXECUTION=0                   # no `new Function`: pages with a strict Content-Security-Policy work
  -sINCOMING_MODULE_JS_API=wasmBinary     # the only option that we pass; the code for the others goes away
  -sTEXTDECODER=2                         # every browser has one
  -sASSERTIONS=0
  -sMALLOC=dlmalloc                       # JSON is many small pieces, for which emmalloc takes half as long again
  -fwasm-exceptions                       # every current browser has them; -fexceptions leaves C++ at each call that might throw
  -sMAXIMUM_MEMORY=4GB
  -sINITIAL_MEMORY=4MB
  -s${stack_setting}=1048576
  -Wl,--stack-first)                      # no more stack is a trap, not a write into what lies below it
