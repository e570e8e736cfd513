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
  # What ccache wants of files that use precompiled headers. It learns from the compiler which files
  # are included (CCACHE_DEPEND), instead of preprocessing each one that it does not know.
  set(launcher "${CMAKE_COMMAND}" -E env
    CCACHE_SLOPPINESS=pch_defines,time_macros CCACHE_DEPEND=1 "${LIXEL_CCACHE}")
  set(CMAKE_C_COMPILER_LAUNCHER "${launcher}")
  set(CMAKE_CXX_COMPILER_LAUNCHER "${launcher}")
endif()

# lixel_precompile(TARGET HEADERS…) or lixel_precompile(TARGET REUSE_FROM OTHER): compiles headers
# once for all files of a target, and of those that reuse them: libraries from libraries, programs
# from programs. OGRE's, Eigen's and GoogleTest's headers are half of the time of most files.
# -DCMAKE_DISABLE_PRECOMPILE_HEADERS=ON builds without, and finds files that lack an include.
function(lixel_precompile target)
  if("${ARGV1}" STREQUAL "REUSE_FROM")
    target_precompile_headers(${target} REUSE_FROM "${ARGV2}")
  else()
    target_precompile_headers(${target} PRIVATE ${ARGN})
  endif()
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    # What ccache wants.
    target_compile_options(${target} PRIVATE -fpch-preprocess)
  endif()
endfunction()

# Options of every target that is our own code.
add_library(lixel_options INTERFACE)
target_compile_options(lixel_options INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wconversion $<$<BOOL:${LIXEL_WERROR}>:-Werror>)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
  # Wrong where a literal and a std::string are added (GCC's bug 105651).
  target_compile_options(lixel_options INTERFACE -Wno-restrict)
endif()
if(LIXEL_SANITIZE)
  # libOgreMain and the Debian libraries are not instrumented; their vtables have no type information
  # that the vptr check could use.
  target_compile_options(lixel_options INTERFACE
    -fsanitize=address,undefined -fno-sanitize=vptr -fno-sanitize-recover=undefined
    -fno-omit-frame-pointer -g1)
  target_link_options(lixel_options INTERFACE -fsanitize=address,undefined)
endif()

# lixel_room(FOLDER SOURCES … USES … PRECOMPILE …): one room of the plugin, an object library
# lixel_FOLDER, with _ for each / in FOLDER. PRECOMPILE is what lixel_precompile takes.
#
# A room's headers are reached as "FOLDER/Header.h" through a directory that holds that room alone, so
# that including a room which is not among USES (or theirs) does not build.
function(lixel_room folder)
  cmake_parse_arguments(ARG "" "" "SOURCES;USES;PRECOMPILE" ${ARGN})
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
  lixel_precompile(lixel_${name} ${ARG_PRECOMPILE})
endfunction()
