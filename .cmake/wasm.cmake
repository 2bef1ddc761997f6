# WebAssembly build: core.mjs (a factory function) and core.wasm, which .scripts/build.mjs inlines.
add_executable(warpjet_wasm js-bindings/bindings.cpp)
target_link_libraries(warpjet_wasm PRIVATE warpjet_core)
set_target_properties(warpjet_wasm PROPERTIES OUTPUT_NAME core SUFFIX .mjs)

# What runs once per warp, or per name in it, is compiled for size; what runs per node stays at -O3
# (-Os everywhere made a warp of 3,000 nodes six times slower).
set_source_files_properties(js-bindings/bindings.cpp PROPERTIES COMPILE_OPTIONS -Oz)
set_source_files_properties(src/emit/names.cpp src/emit/syntax.cpp src/ops/ops.cpp src/warp/warp.cpp
  TARGET_DIRECTORY warpjet_core PROPERTIES COMPILE_OPTIONS -Oz)

# emcc renamed the setting in 3.1.25. No recursion over nodes (see DESIGN), so the stack can be small.
if(EMSCRIPTEN_VERSION VERSION_LESS 3.1.25)
  set(stack_setting TOTAL_STACK)
else()
  set(stack_setting STACK_SIZE)
endif()

target_link_options(warpjet_wasm PRIVATE
  -flto                                 # see CMakeLists.txt
  --bind                                # embind for the few rich calls
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
  -sMALLOC=emmalloc                     # the smallest allocator that frees
  -sFILESYSTEM=0                        # nothing reads files
  -sASSERTIONS=0)
