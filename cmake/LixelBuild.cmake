# How Lixel's own code is compiled: C++20, warnings as errors, ccache where it is installed, and one
# include directory per room so that a room sees only the rooms before it in the data's way.

if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "Build type" FORCE)
endif()

set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)
set(CMAKE_CXX_VISIBILITY_PRESET hidden)
set(CMAKE_VISIBILITY_INLINES_HIDDEN ON)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY "${PROJECT_BINARY_DIR}/bin")
set(CMAKE_LIBRARY_OUTPUT_DIRECTORY "${PROJECT_BINARY_DIR}/lib")

find_program(LIXEL_CCACHE ccache)
if(LIXEL_CCACHE)
  # What ccache wants of files that use precompiled headers.
  set(launcher "${CMAKE_COMMAND}" -E env CCACHE_SLOPPINESS=pch_defines,time_macros
    "${LIXEL_CCACHE}")
  set(CMAKE_C_COMPILER_LAUNCHER "${launcher}")
  set(CMAKE_CXX_COMPILER_LAUNCHER "${launcher}")
endif()

# lixel_precompile(TARGET HEADERS…): compiles headers once for all files of a target: of tests and
# samples, which spend half of their time on those of OGRE, Eigen and GoogleTest. Not of the plugin,
# so that a file there which lacks an include does not build.
function(lixel_precompile target)
  target_precompile_headers(${target} PRIVATE ${ARGN})
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    target_compile_options(${target} PRIVATE -fpch-preprocess)
  endif()
endfunction()

# Options of every target that is our own code.
add_library(lixel_options INTERFACE)
target_compile_options(lixel_options INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wconversion $<$<BOOL:${LIXEL_WERROR}>:-Werror>)
if(LIXEL_SANITIZE)
  # libOgreMain and the Debian libraries are not instrumented; their vtables have no type information
  # that the vptr check could use.
  target_compile_options(lixel_options INTERFACE
    -fsanitize=address,undefined -fno-sanitize=vptr -fno-sanitize-recover=undefined
    -fno-omit-frame-pointer -g1)
  target_link_options(lixel_options INTERFACE -fsanitize=address,undefined)
endif()

# lixel_room(FOLDER SOURCES … USES …): one room of the plugin, an object library lixel_FOLDER, with _
# for each / in FOLDER.
#
# A room's headers are reached as "FOLDER/Header.h" through a directory that holds that room alone, so
# that including a room which is not among USES (or theirs) does not build.
function(lixel_room folder)
  cmake_parse_arguments(ARG "" "" "SOURCES;USES" ${ARGN})
  string(REPLACE "/" "_" name "${folder}")
  set(rooms "${PROJECT_BINARY_DIR}/rooms/${name}")
  get_filename_component(above "${rooms}/${folder}" DIRECTORY)
  file(MAKE_DIRECTORY "${above}")
  file(CREATE_LINK "${PROJECT_SOURCE_DIR}/plugin/${folder}" "${rooms}/${folder}" SYMBOLIC)
  add_library(lixel_${name} OBJECT ${ARG_SOURCES})
  target_include_directories(lixel_${name} PUBLIC "${rooms}")
  target_compile_definitions(lixel_${name} PRIVATE LIXEL_BUILDING)
  target_link_libraries(lixel_${name} PUBLIC ${ARG_USES} PRIVATE lixel_options)
  # OGRE's exceptions name the file that throws, on every machine where Lixel is used.
  target_compile_options(lixel_${name} PRIVATE
    "-fmacro-prefix-map=${PROJECT_SOURCE_DIR}/plugin/=Lixel/")
endfunction()
