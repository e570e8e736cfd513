# Which OGRE Lixel is built with, and used with. Included by Lixel's build and, installed beside
# LixelConfig.cmake, when an application finds the package Lixel. All that differs between OGRE's versions for
# CMake is here; for C++ it is in plugin/scene/OgreVersions.h.

set(LIXEL_OLDEST_OGRE 1.12.10)
set(LIXEL_NEWEST_OGRE 14) # any version that begins so

# lixel_find_ogre([VERSION]): finds OGRE, of exactly that version where one is given, and checks it.
#
# Sets LIXEL_OGRE_SHADOW_MEDIA to OGRE's own programs for shadows, which a resource group has to hold,
# and LIXEL_OGRE_USES_EGL to whether its OpenGL render systems make their contexts with EGL or GLX.
macro(lixel_find_ogre)
  if("${ARGN}" STREQUAL "")
    lixel_forget_ogre_of_other_prefixes()
  endif()
  set(lixel_asked_ogre_dir "${OGRE_DIR}")
  # Without a version, because OGRE's package says of any but its own major one that it will not do.
  if("${ARGN}" STREQUAL "")
    find_package(OGRE CONFIG REQUIRED)
    set(LIXEL_OGRE_DIR "${OGRE_DIR}" CACHE INTERNAL "Where the last search found OGRE")
    set(LIXEL_OGRE_PREFIXES "${CMAKE_PREFIX_PATH}" CACHE INTERNAL "CMAKE_PREFIX_PATH then")
  else()
    find_package(OGRE ${ARGN} EXACT CONFIG REQUIRED)
  endif()
  lixel_check_ogre("${lixel_asked_ogre_dir}")
  # Their folder was renamed in 13.
  foreach(lixel_folder Main ShadowVolume)
    if(EXISTS "${OGRE_MEDIA_DIR}/${lixel_folder}")
      set(LIXEL_OGRE_SHADOW_MEDIA "${OGRE_MEDIA_DIR}/${lixel_folder}")
      break()
    endif()
  endforeach()
  set(LIXEL_OGRE_USES_EGL OFF)
  if(EXISTS "${OGRE_PLUGIN_DIR}/RenderSystem_GL3Plus.so")
    # The libraries that it needs are among its strings.
    file(STRINGS "${OGRE_PLUGIN_DIR}/RenderSystem_GL3Plus.so" lixel_egl
         REGEX "^libEGL\\.so" LIMIT_COUNT 1)
    if(lixel_egl)
      set(LIXEL_OGRE_USES_EGL ON)
    endif()
  endif()
endmacro()

# find_package keeps what it once found. Where CMAKE_PREFIX_PATH has changed since, it searches anew;
# what was given by -DOGRE_DIR stays.
function(lixel_forget_ogre_of_other_prefixes)
  get_property(type CACHE OGRE_DIR PROPERTY TYPE)
  if(DEFINED LIXEL_OGRE_PREFIXES AND NOT LIXEL_OGRE_PREFIXES STREQUAL "${CMAKE_PREFIX_PATH}" AND
     "${OGRE_DIR}" STREQUAL "${LIXEL_OGRE_DIR}" AND NOT type STREQUAL "UNINITIALIZED")
    unset(OGRE_DIR CACHE)
  endif()
endfunction()

# Refuses an OGRE that was not asked for, or that Lixel does not work with, in one line.
function(lixel_check_ogre asked_dir)
  if(asked_dir AND NOT asked_dir MATCHES "-NOTFOUND$")
    get_filename_component(asked "${asked_dir}" REALPATH)
    get_filename_component(found "${OGRE_DIR}" REALPATH)
    if(NOT asked STREQUAL found)
      message(FATAL_ERROR "Lixel: OGRE_DIR is ${asked_dir}, and there is no usable OGREConfig.cmake "
        "in it; OGRE ${OGRE_VERSION} in ${OGRE_DIR} was not asked for")
    endif()
  endif()
  if(OGRE_VERSION VERSION_LESS LIXEL_OLDEST_OGRE OR
     (OGRE_VERSION VERSION_GREATER LIXEL_NEWEST_OGRE AND
      NOT OGRE_VERSION MATCHES "^${LIXEL_NEWEST_OGRE}\\."))
    message(FATAL_ERROR "Lixel: OGRE ${OGRE_VERSION} in ${OGRE_DIR} will not do: it has to be one of "
      "${LIXEL_OLDEST_OGRE} to ${LIXEL_NEWEST_OGRE}.x. Name another by -DOGRE_DIR=, the folder of "
      "its OGREConfig.cmake")
  endif()
  list(GET OGRE_INCLUDE_DIRS 0 include)
  file(STRINGS "${include}/OgreBuildSettings.h" double
       REGEX "^#define[ \t]+OGRE_DOUBLE_PRECISION[ \t]+1")
  if(double)
    message(FATAL_ERROR "Lixel: OGRE ${OGRE_VERSION} in ${OGRE_DIR} was built in double precision "
      "(OGRE_CONFIG_DOUBLE), which Lixel does not work with")
  endif()
  message(STATUS "Lixel: OGRE ${OGRE_VERSION}, found in ${OGRE_DIR}")
endfunction()

# lixel_ogre_library(VARIABLE NAME): a library of the OGRE that was found, and of no other.
function(lixel_ogre_library variable name)
  # Debian's package gives its library folder without the architecture's.
  get_filename_component(beside "${OGRE_DIR}/../.." ABSOLUTE)
  find_library(library "${name}" HINTS "${beside}" ${OGRE_LIBRARY_DIRS}
               NO_DEFAULT_PATH NO_CACHE REQUIRED)
  set(${variable} "${library}" PARENT_SCOPE)
endfunction()

# lixel_ogre_target(NAME LIBRARIES … INCLUDES …): an imported target whose headers count as system
# headers: OGRE's own warnings are not ours.
function(lixel_ogre_target name)
  cmake_parse_arguments(ARG "" "" "LIBRARIES;INCLUDES" ${ARGN})
  if(TARGET ${name}) # another directory of the same project has found Lixel before
    return()
  endif()
  add_library(${name} INTERFACE IMPORTED GLOBAL)
  target_link_libraries(${name} INTERFACE ${ARG_LIBRARIES})
  target_include_directories(${name} SYSTEM INTERFACE ${ARG_INCLUDES})
endfunction()

# lixel_ogre_main(): the target Lixel::OgreMain.
macro(lixel_ogre_main)
  lixel_ogre_library(LIXEL_OGRE_MAIN OgreMain)
  lixel_ogre_target(Lixel::OgreMain LIBRARIES "${LIXEL_OGRE_MAIN}" INCLUDES ${OGRE_INCLUDE_DIRS})
endmacro()

# lixel_ogre_rtss(): the target Lixel::OgreRTShaderSystem.
macro(lixel_ogre_rtss)
  lixel_ogre_library(LIXEL_OGRE_RTSS OgreRTShaderSystem)
  lixel_ogre_target(Lixel::OgreRTShaderSystem
    LIBRARIES "${LIXEL_OGRE_RTSS}" INCLUDES ${OGRE_INCLUDE_DIRS})
endmacro()
