# WebAssembly build. Each module NAME is built as NAME.wasm, which .scripts/build.mjs inlines, and NAME.mjs, Emscripten's factory of
# instances. js-bindings/wasm/NAME.cpp defines its embind bindings.
#   core        the compiler; no SIMD, so that it runs wherever WebAssembly does
#   evaluation  runs programs for many vertices
#   mesh        mesh files and operations on meshes
#   detail      divides triangles as finely as a warped surface on the screen needs
#   glsl        converts shader source to a listing of the core's operations

# Everything is compiled with CMake's -O3 (Release), except code that runs once per glTF file, such as the checks of its JSON: that code
# takes no noticeable time, and is compiled with -Oz. The core at -Oz took 2.8 times as long for a warp of 3,000 nodes, and was 40 KB
# smaller, gzipped.
set_source_files_properties(
  src/mesh/gltf/container.cpp src/mesh/gltf/export.cpp src/mesh/gltf/gltf.cpp src/mesh/load.cpp src/mesh/gltf/look.cpp
  src/mesh/gltf/scene.cpp src/mesh/gltf/schema.cpp src/mesh/messages.cpp src/mesh/gltf/tinygltf.cpp src/mesh/gltf/uri.cpp
  TARGET_DIRECTORY warpjet_mesh PROPERTIES COMPILE_OPTIONS -Oz)

# Keeps clang from replacing pow(2, x) by exp2, which JavaScript's Math lacks.
set_property(SOURCE src/ops/ops.cpp src/ops/interval.cpp src/ops/interval_functions.cpp src/ops/interval_steps.cpp TARGET_DIRECTORY warpjet_core APPEND PROPERTY COMPILE_OPTIONS -fno-builtin)

# Enables SIMD for the code that computes four vertices or triangles at a time. The core module must not contain that code, since link-time
# optimization would enable SIMD for all functions of a module that contains one such function.
set_source_files_properties(js-bindings/wasm/evaluation.cpp js-bindings/wasm/detail.cpp PROPERTIES COMPILE_OPTIONS -msimd128)
set_source_files_properties(
  src/eval/blocks.cpp src/eval/code_writer.cpp src/eval/each_lane.cpp src/eval/machine_code.cpp src/eval/stages.cpp
  TARGET_DIRECTORY warpjet_core PROPERTIES COMPILE_OPTIONS -msimd128)
# Vectorized loops, which are mostly short, would be larger and not faster.
target_compile_options(warpjet_detail PRIVATE -msimd128 -fno-vectorize)

# emcc 3.1.25 renamed the setting.
if(EMSCRIPTEN_VERSION VERSION_LESS 3.1.25)
  set(stack_setting TOTAL_STACK)
else()
  set(stack_setting STACK_SIZE)
endif()

# Our replacements for parts of embind's JavaScript; each file explains why.
set(embind_libraries ${PROJECT_SOURCE_DIR}/.cmake/embind-array.js ${PROJECT_SOURCE_DIR}/.cmake/embind-invoker.js
                     ${PROJECT_SOURCE_DIR}/.cmake/embind-text.js)

# warpjet_module(NAME STACK LIBRARY…): links js-bindings/wasm/NAME.cpp.
function(warpjet_module name stack)
  set(target warpjet_${name}_wasm)
  add_executable(${target} js-bindings/wasm/${name}.cpp)
  set_target_properties(${target} PROPERTIES OUTPUT_NAME ${name} SUFFIX .mjs LINK_DEPENDS "${embind_libraries}")
  target_link_libraries(${target} PRIVATE ${ARGN})
  # Types need no names at run time, since all types that are passed to or from JavaScript are bound.
  target_compile_options(${target} PRIVATE -fno-rtti -DEMSCRIPTEN_HAS_UNBOUND_TYPE_NAMES=0)
  foreach(library ${embind_libraries})
    target_link_options(${target} PRIVATE "SHELL:--js-library ${library}")
  endforeach()
  target_link_options(${target} PRIVATE
    -flto                                 # see CMakeLists.txt
    --no-entry                            # a library: there is no main()
    -lembind
    -fno-rtti                             # chooses the variant of embind's library
    -sMODULARIZE                          # a factory: nothing happens at import, nothing global
    -sEXPORT_ES6                          # `export default factory`, for the bundler
    -sENVIRONMENT=web                     # in 3.1.6, the JavaScript for Node does not run as an ES module; that for the web also runs in Node if we pass the wasm bytes
    -sWASM_ASYNC_COMPILATION=0            # the factory returns the module itself, no promise
    -sDYNAMIC_EXECUTION=0                 # no `new Function`: pages with a strict Content-Security-Policy work
    -sINCOMING_MODULE_JS_API=wasmBinary,printErr  # the options that we pass; omits the code for others
    -sTEXTDECODER=2                       # every browser has a TextDecoder
    -sASSERTIONS=0
    -sALLOW_MEMORY_GROWTH                 # graphs and meshes of any size
    -sSUPPORT_ERRNO=0                     # nothing reads errno
    -sFILESYSTEM=0                        # nothing reads files
    -s${stack_setting}=${stack})
endfunction()

# Like warpjet_module, but code that throws does not link, since no exception may leave these modules. If memory runs out, malloc
# aborts the instance, since embind doesn't check its allocations.
function(warpjet_module_without_exceptions name)
  warpjet_module(${name} ${ARGN})
  target_compile_options(warpjet_${name}_wasm PRIVATE -fno-exceptions)
  target_link_options(warpjet_${name}_wasm PRIVATE
    -fno-exceptions
    -sMALLOC=dlmalloc                     # link-time optimization would inline emmalloc everywhere: 70 KB more, and slower
    -sABORTING_MALLOC=1
    -sINITIAL_MEMORY=2MB                  # a page that warps one mesh needs no more
    -sJS_MATH)                            # uses JavaScript's Math for C's functions: 20 KB less than musl's, whose tables compress badly
endfunction()

# The features that modules without SIMD may use. The list lacks simd128, so that linking fails if such a module contains SIMD code.
set(without_simd
  "SHELL:-Xlinker --features=mutable-globals,sign-ext,bulk-memory,bulk-memory-opt,multivalue,reference-types,nontrapping-fptoint,call-indirect-overlong")

# No function of the core recurses over nodes, so the stack can be small.
warpjet_module_without_exceptions(core 262144 warpjet_core)
warpjet_module_without_exceptions(evaluation 262144 warpjet_core)
target_compile_options(warpjet_core PRIVATE -fno-rtti)
target_link_options(warpjet_core_wasm PRIVATE ${without_simd})

# The parser limits the nesting of a source, and each level takes less than 1 KB.
warpjet_module_without_exceptions(glsl 1048576 warpjet_source)
target_link_options(warpjet_glsl_wasm PRIVATE ${without_simd} -Wl,--stack-first)

warpjet_module_without_exceptions(detail 262144 warpjet_detail)

# A malicious file may request any amount of memory and nest arbitrarily deep. tinygltf and its JSON parser throw;
# js-bindings/wasm/mesh.cpp catches everything.
warpjet_module(mesh 1048576 warpjet_mesh warpjet_core)
target_compile_options(warpjet_mesh_wasm PRIVATE -fwasm-exceptions)
target_compile_options(warpjet_mesh PRIVATE -fwasm-exceptions)
target_link_options(warpjet_mesh_wasm PRIVATE
  -fwasm-exceptions                       # every current browser supports these; with -fexceptions, each call that might throw goes through JavaScript
  -sMALLOC=dlmalloc                       # JSON takes many small allocations, for which emmalloc needs 1.5 times as long
  -sMAXIMUM_MEMORY=4GB
  -sINITIAL_MEMORY=4MB
  -Wl,--stack-first)                      # a stack overflow traps instead of overwriting the data below the stack
