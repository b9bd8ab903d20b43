# Header-only libraries, as dimline::glm, dimline::json, dimline::stb, dimline::tinygltf and dimline::catch2.
#
# They come from the system's packages. Each is linked into a folder of the build tree that holds nothing else, and that
# folder is what goes on the include path: the wasm compiler must never see the rest of the system's include folder.

set(DIMLINE_THIRD_PARTY_DIR "${CMAKE_BINARY_DIR}/third_party")

# dimline_header_library(<name> <entry> <probe> <package> [definitions...])
#   entry: what to link, a folder or a header; probe: a header that must be there, relative to the include folder.
function(dimline_header_library name entry probe package)
  find_path(DIMLINE_${name}_ROOT "${probe}" PATHS /usr/local/include /usr/include /opt/homebrew/include
            NO_CMAKE_FIND_ROOT_PATH)
  mark_as_advanced(DIMLINE_${name}_ROOT)
  if(NOT DIMLINE_${name}_ROOT)
    message(FATAL_ERROR "${probe} is missing: install the package ${package}, or run python3 tools/setup.py.")
  endif()
  set(folder "${DIMLINE_THIRD_PARTY_DIR}/${name}")
  file(MAKE_DIRECTORY "${folder}")
  file(CREATE_LINK "${DIMLINE_${name}_ROOT}/${entry}" "${folder}/${entry}" SYMBOLIC)
  add_library(dimline_${name} INTERFACE)
  add_library(dimline::${name} ALIAS dimline_${name})
  target_include_directories(dimline_${name} SYSTEM INTERFACE "${folder}")
  target_compile_definitions(dimline_${name} INTERFACE ${ARGN})
endfunction()

dimline_header_library(glm glm glm/glm.hpp libglm-dev)
# Without exceptions json reports errors by its return value (parse with allow_exceptions = false); the same in every build.
dimline_header_library(json nlohmann nlohmann/json.hpp nlohmann-json3-dev JSON_NOEXCEPTION)
dimline_header_library(stb stb stb/stb_image.h libstb-dev)
dimline_header_library(tinygltf tiny_gltf.h tiny_gltf.h libtinygltf-dev TINYGLTF_NOEXCEPTION)
target_link_libraries(dimline_tinygltf INTERFACE dimline_json dimline_stb)
# Debian's tiny_gltf.h names stb's headers without their folder.
target_include_directories(dimline_tinygltf SYSTEM INTERFACE "${DIMLINE_THIRD_PARTY_DIR}/stb/stb")
if(NOT EMSCRIPTEN)
  dimline_header_library(catch2 catch2 catch2/catch.hpp catch2)
endif()

# dimline::gl: OpenGL ES 3.0. Natively on an EGL context, in the page on WebGL 2.
add_library(dimline_gl INTERFACE)
add_library(dimline::gl ALIAS dimline_gl)
if(EMSCRIPTEN)
  target_link_options(dimline_gl INTERFACE -sMIN_WEBGL_VERSION=2 -sMAX_WEBGL_VERSION=2)
else()
  find_library(DIMLINE_EGL_LIBRARY EGL)
  find_library(DIMLINE_GLES_LIBRARY GLESv2)
  mark_as_advanced(DIMLINE_EGL_LIBRARY DIMLINE_GLES_LIBRARY)
  if(NOT DIMLINE_EGL_LIBRARY OR NOT DIMLINE_GLES_LIBRARY)
    message(FATAL_ERROR "EGL or GLESv2 is missing: install libegl-dev and libgles-dev, or run python3 tools/setup.py.")
  endif()
  target_link_libraries(dimline_gl INTERFACE "${DIMLINE_EGL_LIBRARY}" "${DIMLINE_GLES_LIBRARY}")
endif()
