# dimline_module(<folder> [OBJECT] [DEPS <folders it may include>...] [LIBS <other libraries>...] [EXCLUDE <files>...] [APART <files>...]
#                [WASM <level>] [WASM_O2 <files>...] [WASM_Os <files>...] [WASM_Oz <files>...])
#
# The library dimline_<folder> out of every .cpp in src/<folder>; a folder of headers alone makes an interface library.
# OBJECT keeps every file in the link, for code that registers itself and is called by no name.
# APART are files that a unity build leaves alone: they use names that others of the folder use too, in unnamed namespaces.
# DEPS is the only way in which a folder reaches another one: tools/check_includes.py holds the sources to it.
# WASM is what the WebAssembly build optimises the folder for (-O2, -Os, -Oz; -O3 when nothing is said), since a page has to fetch it;
# the lists of files are what it optimises otherwise. Native builds take no notice.
function(dimline_module folder)
  cmake_parse_arguments(PARSE_ARGV 1 arg "OBJECT" "WASM" "DEPS;LIBS;EXCLUDE;APART;WASM_O2;WASM_Os;WASM_Oz")
  if(arg_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "dimline_module(${folder}): what is ${arg_UNPARSED_ARGUMENTS}?")
  endif()

  file(GLOB sources CONFIGURE_DEPENDS "${CMAKE_CURRENT_SOURCE_DIR}/*.cpp")
  foreach(name IN LISTS arg_EXCLUDE)
    list(REMOVE_ITEM sources "${CMAKE_CURRENT_SOURCE_DIR}/${name}")
  endforeach()
  if(arg_APART)
    set_source_files_properties(${arg_APART} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
  endif()
  file(GLOB headers CONFIGURE_DEPENDS "${CMAKE_CURRENT_SOURCE_DIR}/*.h")

  list(TRANSFORM arg_DEPS PREPEND dimline_)
  set(target dimline_${folder})
  if(NOT sources)
    add_library(${target} INTERFACE)
    target_link_libraries(${target} INTERFACE ${arg_DEPS} ${arg_LIBS})
    target_include_directories(${target} INTERFACE "${PROJECT_SOURCE_DIR}/src" "${DIMLINE_GENERATED_DIR}")
    return()
  endif()

  # A target for the files of each level, since precompiled headers and unity builds go by targets.
  set(others "")
  if(EMSCRIPTEN)
    foreach(level IN ITEMS O2 Os Oz)
      set(files ${arg_WASM_${level}})
      if(files)
        list(TRANSFORM files PREPEND "${CMAKE_CURRENT_SOURCE_DIR}/")
        list(REMOVE_ITEM sources ${files})
        add_library(${target}_${level} OBJECT ${files})
        dimline_module_properties(${target}_${level} -${level})
        # What one file would inline of another makes the module larger.
        set_target_properties(${target}_${level} PROPERTIES UNITY_BUILD OFF)
        list(APPEND others $<TARGET_OBJECTS:${target}_${level}>)
      endif()
    endforeach()
  endif()

  if(arg_OBJECT)
    add_library(${target} OBJECT ${sources} ${headers})
  else()
    add_library(${target} STATIC ${others} ${sources} ${headers})
  endif()
  dimline_module_properties(${target} ${arg_WASM})
endfunction()

# What every target of the module that is being made has, in WebAssembly with this optimisation. A macro: it sees the module's arguments.
macro(dimline_module_properties name)
  target_link_libraries(${name} PUBLIC ${arg_DEPS} ${arg_LIBS} PRIVATE dimline_module_flags)
  target_include_directories(${name} PUBLIC "${PROJECT_SOURCE_DIR}/src" "${DIMLINE_GENERATED_DIR}")
  if(EMSCRIPTEN)
    target_compile_options(${name} PRIVATE ${ARGN})
    dimline_precompiled(${name} ${ARGN})
  else()
    dimline_precompiled(${name})
  endif()
endmacro()
