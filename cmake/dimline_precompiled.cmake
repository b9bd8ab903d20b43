# Headers that nearly every file includes, parsed once a build instead of once a file: that is two thirds of a file's
# compile time. In native builds only: the wasm build goes without, so a file that forgets an include does not pass.
#
# dimline_precompiled(<target>)        for what ships
# dimline_precompiled_test(<target>)   for tests: with exceptions, and with Catch2

if(EMSCRIPTEN)
  function(dimline_precompiled target)
  endfunction()
  return()
endif()

set(DIMLINE_PRECOMPILED
  <algorithm> <array> <cmath> <cstdint> <limits> <map> <memory> <optional> <ranges> <span> <string> <string_view> <utility> <vector>
  <glm/glm.hpp> <glm/gtc/quaternion.hpp>)

# An empty file carries each set of headers; targets of the same flags use it again.
file(WRITE "${CMAKE_BINARY_DIR}/generated/empty.cpp.new" "// Carries the precompiled headers.\n")
configure_file("${CMAKE_BINARY_DIR}/generated/empty.cpp.new" "${CMAKE_BINARY_DIR}/generated/empty.cpp" COPYONLY)

add_library(dimline_headers OBJECT "${CMAKE_BINARY_DIR}/generated/empty.cpp")
target_link_libraries(dimline_headers PRIVATE dimline::glm dimline_module_flags)
target_precompile_headers(dimline_headers PRIVATE ${DIMLINE_PRECOMPILED})

add_library(dimline_test_headers OBJECT EXCLUDE_FROM_ALL "${CMAKE_BINARY_DIR}/generated/empty.cpp")
target_link_libraries(dimline_test_headers PRIVATE dimline::glm dimline::catch2 dimline_flags)
target_precompile_headers(dimline_test_headers PRIVATE ${DIMLINE_PRECOMPILED} <catch2/catch.hpp>)

function(dimline_precompiled target)
  target_precompile_headers(${target} REUSE_FROM dimline_headers)
endfunction()
function(dimline_precompiled_test target)
  target_precompile_headers(${target} REUSE_FROM dimline_test_headers)
endfunction()
