# Headers that nearly every file includes, parsed once a build instead of once a file: that is two thirds of a file's
# compile time. That no file forgets what it includes is seen to by tools/check_includes.py.
#
# dimline_precompiled(<target> [<level>])   for what ships; level: what the target is optimised for, when not for speed (-Os, -Oz)
# dimline_precompiled_test(<target>)        for tests: with exceptions, and with Catch2

set(DIMLINE_PRECOMPILED
  <algorithm> <array> <cmath> <cstdint> <limits> <map> <memory> <optional> <ranges> <span> <string> <string_view> <utility> <vector>
  <glm/glm.hpp> <glm/gtc/quaternion.hpp>)

# An empty file carries each set of headers; targets of the same flags use it again.
file(WRITE "${CMAKE_BINARY_DIR}/generated/empty.cpp.new" "// Carries the precompiled headers.\n")
configure_file("${CMAKE_BINARY_DIR}/generated/empty.cpp.new" "${CMAKE_BINARY_DIR}/generated/empty.cpp" COPYONLY)

function(dimline_header_carrier name)
  add_library(${name} OBJECT EXCLUDE_FROM_ALL "${CMAKE_BINARY_DIR}/generated/empty.cpp")
  target_link_libraries(${name} PRIVATE dimline::glm ${ARGN})
endfunction()

dimline_header_carrier(dimline_headers dimline_module_flags)
target_precompile_headers(dimline_headers PRIVATE ${DIMLINE_PRECOMPILED})

if(EMSCRIPTEN)
  # Clang takes no headers that were parsed for speed where it compiles for size.
  dimline_header_carrier(dimline_headers_small dimline_module_flags)
  target_compile_options(dimline_headers_small PRIVATE -Oz)
  target_precompile_headers(dimline_headers_small PRIVATE ${DIMLINE_PRECOMPILED})
else()
  dimline_header_carrier(dimline_test_headers dimline::catch2 dimline_flags)
  target_precompile_headers(dimline_test_headers PRIVATE ${DIMLINE_PRECOMPILED} <catch2/catch.hpp>)
endif()

function(dimline_precompiled target)
  if("${ARGN}" MATCHES "^-O[sz]$")
    target_precompile_headers(${target} REUSE_FROM dimline_headers_small)
  else()
    target_precompile_headers(${target} REUSE_FROM dimline_headers)
  endif()
endfunction()
function(dimline_precompiled_test target)
  target_precompile_headers(${target} REUSE_FROM dimline_test_headers)
endfunction()
