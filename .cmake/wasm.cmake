# WebAssembly build: core.mjs (a factory function) and core.wasm, which .scripts/build.mjs inlines.
add_executable(warpjet_wasm js-bindings/bindings.cpp .cmake/math.cpp)
target_link_libraries(warpjet_wasm PRIVATE warpjet_core)
set_target_properties(warpjet_wasm PROPERTIES OUTPUT_NAME core SUFFIX .mjs
  LINK_DEPENDS ${PROJECT_SOURCE_DIR}/.cmake/embind.js)

# What runs once per warp, or per name in it, is compiled for size; what runs per node stays at -O3
# (-Os everywhere made a warp of 3,000 nodes six times slower), but for what of it was no slower when it was small:
# emit.cpp, statements.cpp, schedule.cpp.
set_source_files_properties(js-bindings/bindings.cpp PROPERTIES COMPILE_OPTIONS -Oz)
set_source_files_properties(
  src/algebra/derivatives.cpp src/algebra/matrices.cpp src/algebra/vectors.cpp src/builder/call.cpp src/builder/construct.cpp
  src/builder/host.cpp src/builder/results.cpp src/builder/sentences.cpp src/diff/partials.cpp src/emit/dialect.cpp src/emit/emit.cpp src/emit/literal.cpp src/emit/lower.cpp src/emit/names.cpp src/emit/schedule.cpp src/emit/statements.cpp
  src/emit/syntax.cpp src/eval/program.cpp src/ops/ops.cpp src/warp/warp.cpp
  TARGET_DIRECTORY warpjet_core PROPERTIES COMPILE_OPTIONS -Oz)

# Or clang would make exp2 of pow(2, x), which JavaScript's Math lacks.
set_property(SOURCE src/ops/ops.cpp TARGET_DIRECTORY warpjet_core APPEND PROPERTY COMPILE_OPTIONS -fno-builtin)

# emcc renamed the setting in 3.1.25. No recursion over nodes (see DESIGN), so the stack can be small.
if(EMSCRIPTEN_VERSION VERSION_LESS 3.1.25)
  set(stack_setting TOTAL_STACK)
else()
  set(stack_setting STACK_SIZE)
endif()

target_link_options(warpjet_wasm PRIVATE
  -flto                                 # see CMakeLists.txt
  --bind                                # embind for the few rich calls
  --js-library ${PROJECT_SOURCE_DIR}/.cmake/embind.js  # without the types that no call has
  --no-entry                            # a library: there is no main()
  -fno-exceptions                       # no exception crosses the border: a throw that is left in the code does not link
  -sMODULARIZE                          # a factory: nothing happens at import, nothing global
  -sEXPORT_ES6                          # `export default factory`, for the bundler
  -sENVIRONMENT=web                     # the glue for Node does not run as an ES module in 3.1.6; with the bytes handed in, this one runs in both
  -sWASM_ASYNC_COMPILATION=0            # the factory returns the module itself, no promise: createWarp works in a plain setup()
  -sDYNAMIC_EXECUTION=0                 # no `new Function`: pages with a strict Content-Security-Policy work
  -sINCOMING_MODULE_JS_API=wasmBinary   # the only option that we pass; the code for the others goes away
  -sALLOW_MEMORY_GROWTH                 # graphs of any size
  -sMEMORY_GROWTH_GEOMETRIC_STEP=1.0    # doubles, since each growth detaches every view of the heap
  -sINITIAL_MEMORY=2MB                  # a page that warps one mesh needs no more
  -s${stack_setting}=262144
  -sJS_MATH                             # sin, pow and others from JavaScript, for folding constants: 16 KB less
  -sMALLOC=emmalloc                     # the smallest allocator that frees
  -sTEXTDECODER=2                       # every browser has one
  -sSUPPORT_ERRNO=0                     # nothing reads it
  -sFILESYSTEM=0                        # nothing reads files
  -sASSERTIONS=0)
