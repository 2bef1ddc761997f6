# WebAssembly build: for each module NAME.wasm, which .scripts/build.mjs inlines, and but for the core NAME.mjs, a factory.
#   core        the compiler; no SIMD, so that it runs wherever WebAssembly does
#   evaluation  programs over many vertices
#   mesh        files of meshes, and what is done to meshes
# And unpack.wasm, which unpacks the others.

# What runs once per warp, or per name in it, is compiled for size; what runs per node stays at -O3
# (-Os everywhere made a warp of 3,000 nodes six times slower), but for what of it was no slower when it was small:
# emit.cpp, statements.cpp, schedule.cpp.
set_source_files_properties(js-bindings/bindings.cpp js-bindings/mesh.cpp PROPERTIES COMPILE_OPTIONS -Oz)
set_source_files_properties(
  src/algebra/derivatives.cpp src/algebra/matrices.cpp src/algebra/vectors.cpp src/builder/builder.cpp src/builder/call.cpp src/builder/construct.cpp
  src/builder/host.cpp src/builder/results.cpp src/module/sentences.cpp src/module/label.cpp src/module/save.cpp src/diff/partials.cpp src/emit/dialect.cpp src/emit/glsl300.cpp src/emit/glsl100.cpp src/emit/wgsl.cpp src/emit/text.cpp src/emit/sums.cpp src/emit/emit.cpp src/emit/literal.cpp src/emit/lower.cpp src/emit/bundle.cpp src/emit/names.cpp src/emit/statements.cpp src/functions/library.cpp src/functions/inline_calls.cpp
  src/emit/functions.cpp src/builder/noise.cpp src/builder/texture.cpp src/texture/texture.cpp src/noise/curl.cpp src/noise/fractal.cpp src/noise/lattice.cpp src/noise/noise.cpp
  src/noise/random.cpp src/noise/simplex.cpp src/noise/worley.cpp src/graph/functions.cpp src/graph/multi_index.cpp src/graph/schedule.cpp
  src/module/syntax.cpp src/emit/writer.cpp src/eval/program.cpp src/ops/ops.cpp src/warp/warp.cpp
  TARGET_DIRECTORY warpjet_core PROPERTIES COMPILE_OPTIONS -Oz)

# The same for meshes: what runs once per file or name in it.
set_source_files_properties(
  src/mesh/gltf/container.cpp src/mesh/gltf/export.cpp src/mesh/gltf/gltf.cpp src/mesh/gltf/json_text.cpp src/mesh/load.cpp src/mesh/gltf/look.cpp
  src/mesh/gltf/scene.cpp src/mesh/gltf/schema.cpp src/mesh/sentences.cpp src/mesh/gltf/tinygltf.cpp src/mesh/gltf/uri.cpp
  TARGET_DIRECTORY warpjet_mesh PROPERTIES COMPILE_OPTIONS -Oz)

# Or clang would make exp2 of pow(2, x), which JavaScript's Math lacks.
set_property(SOURCE src/ops/ops.cpp src/ops/interval.cpp TARGET_DIRECTORY warpjet_core APPEND PROPERTY COMPILE_OPTIONS -fno-builtin)

# What computes four vertices at a time. The core links none of it, for link-time optimisation would give SIMD to all
# functions of a module that has one with it.
set_source_files_properties(js-bindings/evaluation.cpp PROPERTIES COMPILE_OPTIONS -msimd128)
set_source_files_properties(src/eval/blocks.cpp TARGET_DIRECTORY warpjet_core PROPERTIES COMPILE_OPTIONS -msimd128)

# emcc renamed the setting in 3.1.25. No recursion over nodes (see DESIGN), so the stack can be small.
if(EMSCRIPTEN_VERSION VERSION_LESS 3.1.25)
  set(stack_setting TOTAL_STACK)
else()
  set(stack_setting STACK_SIZE)
endif()

# warpjet_module(NAME SOURCES... LINK_OPTIONS...)
function(warpjet_module name)
  cmake_parse_arguments(PARSE_ARGV 1 module "" "" "SOURCES;LINK_OPTIONS")
  set(target warpjet_${name}_wasm)
  add_executable(${target} ${module_SOURCES})
  target_link_libraries(${target} PRIVATE warpjet_core)
  set_target_properties(${target} PROPERTIES OUTPUT_NAME ${name} SUFFIX .mjs)
  target_link_options(${target} PRIVATE
    -flto                                 # see CMakeLists.txt
    --no-entry                            # a library: there is no main()
    -sMODULARIZE                          # a factory: nothing happens at import, nothing global
    -sEXPORT_ES6                          # `export default factory`, for the bundler
    -sENVIRONMENT=web                     # the glue for Node does not run as an ES module in 3.1.6; with the bytes handed in, this one runs in both
    -sWASM_ASYNC_COMPILATION=0            # the factory returns the module itself, no promise: createWarp works in a plain setup()
    -sDYNAMIC_EXECUTION=0                 # no `new Function`: pages with a strict Content-Security-Policy work
    -sINCOMING_MODULE_JS_API=wasmBinary   # the only option that we pass; the code for the others goes away
    -sALLOW_MEMORY_GROWTH                 # graphs and meshes of any size
    -sMALLOC=emmalloc                     # the smallest allocator that frees
    -sTEXTDECODER=2                       # every browser has one
    -sSUPPORT_ERRNO=0                     # nothing reads it
    -sFILESYSTEM=0                        # nothing reads files
    -sASSERTIONS=0
    ${module_LINK_OPTIONS})
endfunction()

# Without Emscripten's JavaScript; js-bindings/core-module.ts has what is imported: C's mathematics, for folding constants
# (16 KB less than musl's), and embind, for the few rich calls, without libembind and type_info, which know every type.
add_executable(warpjet_core_wasm js-bindings/bindings.cpp .cmake/math.cpp)
target_link_libraries(warpjet_core_wasm PRIVATE warpjet_core)
set_target_properties(warpjet_core_wasm PROPERTIES OUTPUT_NAME core SUFFIX .wasm)
target_compile_options(warpjet_core_wasm PRIVATE -fno-exceptions -fno-rtti)
target_compile_options(warpjet_core PRIVATE -fno-rtti)
target_compile_definitions(warpjet_core_wasm PRIVATE EMSCRIPTEN_HAS_UNBOUND_TYPE_NAMES=0)
target_link_options(warpjet_core_wasm PRIVATE
  -flto
  --no-entry
  -fno-exceptions                       # no exception crosses the border: a throw that is left in the code does not link
  "SHELL:-Xlinker --features=mutable-globals,sign-ext,bulk-memory,bulk-memory-opt,multivalue,reference-types,nontrapping-fptoint,call-indirect-overlong"  # not simd128: it does not link if it got in
  -sALLOW_MEMORY_GROWTH
  -sMALLOC=emmalloc
  -sSUPPORT_ERRNO=0
  -sFILESYSTEM=0
  -sINITIAL_MEMORY=2MB                  # a page that warps one mesh needs no more
  -s${stack_setting}=262144
  -sJS_MATH
  -sWARN_ON_UNDEFINED_SYMBOLS=0         # embind's, which emcc does not know without --bind; a wrong one fails at the first warp
  -sERROR_ON_UNDEFINED_SYMBOLS=0)

warpjet_module(evaluation
  SOURCES js-bindings/evaluation.cpp
  LINK_OPTIONS
    -fno-exceptions
    -sINITIAL_MEMORY=2MB
    -s${stack_setting}=262144)
target_compile_options(warpjet_evaluation_wasm PRIVATE -fno-exceptions)

# A file that lies may ask for any amount of memory and nest as deep as it likes. tinygltf and its JSON parser throw;
# js-bindings/mesh.cpp catches everything.
warpjet_module(mesh
  SOURCES js-bindings/mesh.cpp
  LINK_OPTIONS
    --js-library ${PROJECT_SOURCE_DIR}/.cmake/mesh.js
    -sMALLOC=dlmalloc                     # JSON is many small pieces, for which emmalloc takes half as long again
    -fwasm-exceptions                     # every current browser has them; -fexceptions leaves C++ at each call that might throw
    -sMAXIMUM_MEMORY=4GB
    -sINITIAL_MEMORY=4MB
    -s${stack_setting}=1048576
    -Wl,--stack-first)                    # no more stack is a trap, not a write into what lies below it
target_link_libraries(warpjet_mesh_wasm PRIVATE warpjet_mesh)
set_target_properties(warpjet_mesh_wasm PROPERTIES LINK_DEPENDS ${PROJECT_SOURCE_DIR}/.cmake/mesh.js)
target_compile_options(warpjet_mesh_wasm PRIVATE -fwasm-exceptions)
target_compile_options(warpjet_mesh PRIVATE -fwasm-exceptions)

# Alone and without JavaScript. A stack this small and a few models fit one page of memory.
add_executable(warpjet_unpack_wasm js-bindings/unpack.cpp)
set_target_properties(warpjet_unpack_wasm PROPERTIES OUTPUT_NAME unpack SUFFIX .wasm)
set_source_files_properties(js-bindings/unpack.cpp PROPERTIES COMPILE_OPTIONS -Oz)
target_compile_options(warpjet_unpack_wasm PRIVATE -fno-exceptions -fno-rtti)
target_link_options(warpjet_unpack_wasm PRIVATE
  -Oz -flto --no-entry -sSUPPORT_ERRNO=0 -sFILESYSTEM=0 -sALLOW_MEMORY_GROWTH -sINITIAL_MEMORY=64KB -s${stack_setting}=1024
  -Wl,--export=__heap_base)
