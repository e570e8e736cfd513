# Imported targets for OGRE whose headers count as system headers: OGRE's own warnings are not ours.
# Used by Lixel's build and, installed beside LixelConfig.cmake, by whoever finds the package Lixel;
# find_package(OGRE) comes first.

function(lixel_ogre_target name)
  cmake_parse_arguments(ARG "" "" "LIBRARIES;INCLUDES" ${ARGN})
  if(TARGET ${name}) # another directory of the same project has found Lixel before
    return()
  endif()
  add_library(${name} INTERFACE IMPORTED GLOBAL)
  target_link_libraries(${name} INTERFACE ${ARG_LIBRARIES})
  target_include_directories(${name} SYSTEM INTERFACE ${ARG_INCLUDES})
endfunction()

find_library(LIXEL_OGRE_MAIN OgreMain HINTS ${OGRE_LIBRARY_DIRS} REQUIRED)
lixel_ogre_target(Lixel::OgreMain LIBRARIES "${LIXEL_OGRE_MAIN}" INCLUDES "${OGRE_INCLUDE_DIRS}")
