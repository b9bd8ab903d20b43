# Flags that every target of ours gets. Two interface targets: dimline_flags for all, dimline_module_flags for what ships.

option(DIMLINE_SANITIZE "Build with the address and undefined-behaviour sanitizers" OFF)

set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_ARCHIVE_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/lib")

# For unity builds, which the presets ask for: what several files instantiate of the library's templates is compiled once
# for all of them, and that is half of the compile time. Many cores would still like to have several batches.
set(CMAKE_UNITY_BUILD_BATCH_SIZE 8)

if(NOT EMSCRIPTEN)
  find_program(DIMLINE_CCACHE ccache)
  mark_as_advanced(DIMLINE_CCACHE)
  if(DIMLINE_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
    # What ccache has to be told to cache files that use precompiled headers.
    set(CMAKE_CXX_COMPILER_LAUNCHER "${CMAKE_COMMAND}" -E env CCACHE_SLOPPINESS=pch_defines,time_macros "${DIMLINE_CCACHE}")
    add_compile_options($<$<CXX_COMPILER_ID:GNU>:-fpch-preprocess>)
  endif()
endif()

add_library(dimline_flags INTERFACE)
target_compile_options(dimline_flags INTERFACE
  -Wall -Wextra -Wpedantic -Werror
  -Wshadow -Wnon-virtual-dtor -Woverloaded-virtual -Wold-style-cast -Wextra-semi -Wformat=2 -Wcast-qual -Wundef
  # Layouts must be equal bit for bit between runs and hosts: no fused multiply-add where one compiler happens to see one.
  -ffp-contract=off)

if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  # g++ 12 gives both of these for correct code of its own library (string +, optional) once it inlines.
  target_compile_options(dimline_flags INTERFACE -Wno-restrict -Wno-maybe-uninitialized -Wduplicated-cond -Wlogical-op)
endif()

# Line tables only, here as well: a profile and a stack name file and line, and a file compiles a quarter sooner. Asserts stay: who writes a model with the Builder
# learns at once what is wrong. They cost too little to be measured; the module in the page has none.
set(CMAKE_CXX_FLAGS_RELWITHDEBINFO "-O2 -g1")

if(DIMLINE_SANITIZE)
  # -Og and line tables only: a file compiles twice as fast as with -O1, the tests still run in seconds, and a report names file and line.
  set(CMAKE_CXX_FLAGS_DEBUG "-Og -g1")
  # Left out of "undefined": what the address sanitizer or the MMU stops anyway (null, object-size, pointer-overflow), what needs
  # RTTI tricks that there are none of (vptr), and alignment, which src/gltf alone asks for. They are half of a file's compile time.
  add_compile_options(-fsanitize=address,undefined,float-cast-overflow -fno-sanitize=null,object-size,pointer-overflow,vptr,alignment
                      -fno-sanitize-recover=all -fno-omit-frame-pointer)
  add_link_options(-fsanitize=address,undefined)
  add_compile_definitions(_GLIBCXX_ASSERTIONS)
endif()

if(EMSCRIPTEN)
  # Who has SIMD has the conversions that do not trap, too: without them each one is a comparison and a branch.
  add_compile_options(-msimd128 -mbulk-memory -mnontrapping-fptoint -flto -fno-rtti)
  add_link_options(-flto -fno-rtti -mbulk-memory)
  # -fno-rtti at the link too: it chooses the embind library whose type ids are those of code without RTTI.
  # The price: embind's messages cannot name a type that was never registered.
  add_compile_definitions(EMSCRIPTEN_HAS_UNBOUND_TYPE_NAMES=0)
endif()

# The wasm build has no exceptions; compiling the same code natively without them finds a stray `throw` or `try` at once.
add_library(dimline_module_flags INTERFACE)
target_compile_options(dimline_module_flags INTERFACE -fno-exceptions)
target_link_libraries(dimline_module_flags INTERFACE dimline_flags)
