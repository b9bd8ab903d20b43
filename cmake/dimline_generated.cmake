# What is made from other files of the project: core/version.h and shaders.h, both under <build>/generated.

set(DIMLINE_GENERATED_DIR "${CMAKE_BINARY_DIR}/generated")

configure_file("${CMAKE_CURRENT_SOURCE_DIR}/cmake/version.h.in" "${DIMLINE_GENERATED_DIR}/core/version.h" @ONLY)

# dimline_shaders: every shader's text as a string_view, dimline::shaders::<file name with dots as underscores>.
file(GLOB shader_files CONFIGURE_DEPENDS
     "${CMAKE_CURRENT_SOURCE_DIR}/shaders/*.vert"
     "${CMAKE_CURRENT_SOURCE_DIR}/shaders/*.frag"
     "${CMAKE_CURRENT_SOURCE_DIR}/shaders/*.glsl")
# The list lies in a file of its own that changes only with the list: a shader that comes or goes makes the text anew too.
list(JOIN shader_files "\n" shader_list)
file(CONFIGURE OUTPUT "${DIMLINE_GENERATED_DIR}/shaders.list" CONTENT "${shader_list}\n" @ONLY)
add_custom_command(
  OUTPUT "${DIMLINE_GENERATED_DIR}/shaders.h" "${DIMLINE_GENERATED_DIR}/shaders.cpp"
  COMMAND "${CMAKE_COMMAND}" "-DLIST=${DIMLINE_GENERATED_DIR}/shaders.list" "-DOUT=${DIMLINE_GENERATED_DIR}"
          -P "${CMAKE_CURRENT_SOURCE_DIR}/cmake/embed_shaders.cmake"
  DEPENDS ${shader_files} "${DIMLINE_GENERATED_DIR}/shaders.list" "${CMAKE_CURRENT_SOURCE_DIR}/cmake/embed_shaders.cmake"
  COMMENT "Embedding shaders"
  VERBATIM)
add_library(dimline_shaders STATIC "${DIMLINE_GENERATED_DIR}/shaders.cpp" "${DIMLINE_GENERATED_DIR}/shaders.h")
target_include_directories(dimline_shaders PUBLIC "${DIMLINE_GENERATED_DIR}")
target_link_libraries(dimline_shaders PRIVATE dimline_module_flags)
