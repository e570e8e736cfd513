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
  # ccache learns from the compiler which files are included, instead of preprocessing each one that
  # it does not know.
  set(launcher "${CMAKE_COMMAND}" -E env CCACHE_DEPEND=1 "${LIXEL_CCACHE}")
  set(CMAKE_C_COMPILER_LAUNCHER "${launcher}")
  set(CMAKE_CXX_COMPILER_LAUNCHER "${launcher}")
endif()

# Files that -DCMAKE_UNITY_BUILD=ON compiles together. Each alone takes 6 s, of which the headers of
# OGRE, Eigen, GoogleTest and RapidCheck are 3 to 5 s.
if(NOT DEFINED CMAKE_UNITY_BUILD_BATCH_SIZE)
  set(CMAKE_UNITY_BUILD_BATCH_SIZE 8)
endif()

# Options of every target that is our own code.
add_library(lixel_options INTERFACE)
if(CMAKE_UNITY_BUILD)
  # It takes the file that it compiles alone for a header.
  set(unity -Wno-subobject-linkage)
endif()
target_compile_options(lixel_options INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wconversion $<$<BOOL:${LIXEL_WERROR}>:-Werror> ${unity})
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
