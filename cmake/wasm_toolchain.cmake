# Finds Emscripten and hands over to its own toolchain file. Looked for in this order:
#   1. -DDIMLINE_EMSCRIPTEN=<folder of em++>
#   2. an em++ on PATH that is new enough (an activated emsdk)
#   3. the private prefix that tools/setup.py fills
# The version is read from a file beside em++, because starting em++ to ask takes half a second.

set(DIMLINE_EMSCRIPTEN_MINIMUM 3.1.50)

if(NOT DIMLINE_EMSCRIPTEN)
  find_program(DIMLINE_EMXX_ON_PATH em++ NO_CMAKE_PATH NO_CMAKE_FIND_ROOT_PATH)
  mark_as_advanced(DIMLINE_EMXX_ON_PATH)
  if(DIMLINE_EMXX_ON_PATH)
    get_filename_component(candidate "${DIMLINE_EMXX_ON_PATH}" REALPATH)
    get_filename_component(candidate "${candidate}" DIRECTORY)
    if(EXISTS "${candidate}/emscripten-version.txt")
      file(STRINGS "${candidate}/emscripten-version.txt" version LIMIT_COUNT 1)
      string(REGEX MATCH "[0-9]+\\.[0-9]+\\.[0-9]+" version "${version}")
      if(version VERSION_GREATER_EQUAL DIMLINE_EMSCRIPTEN_MINIMUM)
        set(DIMLINE_EMSCRIPTEN "${candidate}")
      endif()
    endif()
  endif()
endif()

if(NOT DIMLINE_EMSCRIPTEN)
  set(cache_home "$ENV{XDG_CACHE_HOME}")
  if(NOT cache_home)
    set(cache_home "$ENV{HOME}/.cache")
  endif()
  set(prefix "${cache_home}/dimline/emscripten-3.1.69")
  if(EXISTS "${prefix}/.done")
    set(DIMLINE_EMSCRIPTEN "${prefix}/usr/share/emscripten")
  endif()
endif()

if(NOT DIMLINE_EMSCRIPTEN)
  message(FATAL_ERROR "No Emscripten ${DIMLINE_EMSCRIPTEN_MINIMUM} or newer: run python3 tools/setup.py, or activate an emsdk.")
endif()

list(APPEND CMAKE_TRY_COMPILE_PLATFORM_VARIABLES DIMLINE_EMSCRIPTEN)
include("${DIMLINE_EMSCRIPTEN}/cmake/Modules/Platform/Emscripten.cmake")
