# dimline_module(<folder> [OBJECT] [DEPS <folders it may include>...] [LIBS <other libraries>...] [EXCLUDE <files>...] [APART <files>...])
#
# The library dimline_<folder> out of every .cpp in src/<folder>; a folder of headers alone makes an interface library.
# OBJECT keeps every file in the link, for code that registers itself and is called by no name.
# APART are files that a unity build leaves alone: they use names that others of the folder use too, in unnamed namespaces.
# DEPS is the only way in which a folder reaches another one: tools/check_includes.py holds the sources to it.
function(dimline_module folder)
  cmake_parse_arguments(PARSE_ARGV 1 arg "OBJECT" "" "DEPS;LIBS;EXCLUDE;APART")
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
  if(sources)
    if(arg_OBJECT)
      add_library(${target} OBJECT ${sources} ${headers})
    else()
      add_library(${target} STATIC ${sources} ${headers})
    endif()
    target_link_libraries(${target} PUBLIC ${arg_DEPS} ${arg_LIBS} PRIVATE dimline_module_flags)
    dimline_precompiled(${target})
    set(scope PUBLIC)
  else()
    add_library(${target} INTERFACE)
    target_link_libraries(${target} INTERFACE ${arg_DEPS} ${arg_LIBS})
    set(scope INTERFACE)
  endif()
  target_include_directories(${target} ${scope} "${PROJECT_SOURCE_DIR}/src" "${DIMLINE_GENERATED_DIR}")
endfunction()
