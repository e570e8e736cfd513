# Which OGRE a build of Lixel takes, shown with packages that have nothing but a version:
#
#     cmake -D SOURCE=… -D WORK=… -P ogre_choice.cmake
#
# SOURCE is Lixel's cmake folder, WORK a folder to be overwritten.

# package(VERSION [DOUBLE]): an OGRE in WORK/VERSION.
function(package version double)
  set(prefix "${WORK}/${version}")
  set(folder "${prefix}/lib/OGRE/cmake")
  file(WRITE "${prefix}/include/OgreBuildSettings.h" "#define OGRE_DOUBLE_PRECISION ${double}\n")
  file(WRITE "${folder}/OGREConfig.cmake"
       "set(OGRE_INCLUDE_DIRS \"${prefix}/include\")\nset(OGRE_MEDIA_DIR \"${prefix}\")\n")
  # As OGRE's own: any version of the same major one will do.
  file(WRITE "${folder}/OGREConfigVersion.cmake" "set(PACKAGE_VERSION ${version})
    string(REGEX MATCH \"^[0-9]+\" major \"\${PACKAGE_FIND_VERSION}\")
    string(REGEX MATCH \"^[0-9]+\" own \"\${PACKAGE_VERSION}\")
    if(major STREQUAL own)
      set(PACKAGE_VERSION_COMPATIBLE TRUE)
    endif()
    if(PACKAGE_FIND_VERSION STREQUAL PACKAGE_VERSION)
      set(PACKAGE_VERSION_EXACT TRUE)
    endif()")
endfunction()

# expect(WHAT SAYS OPTION…): configuring WORK/build with the options says so.
function(expect what says)
  execute_process(
    COMMAND "${CMAKE_COMMAND}" -S "${WORK}/project" -B "${WORK}/build" ${ARGN}
    OUTPUT_VARIABLE output ERROR_VARIABLE output)
  string(REGEX REPLACE "[ \n]+" " " output "${output}") # error messages are wrapped
  if(NOT output MATCHES "${says}")
    message(SEND_ERROR "${what}: expected '${says}', but it said: ${output}")
  endif()
endfunction()

function(start_anew)
  file(REMOVE_RECURSE "${WORK}/build")
endfunction()

file(REMOVE_RECURSE "${WORK}")
foreach(version 1.12.9 1.12.10 13.6.5 14.5.2 15.0.0)
  package(${version} 0)
endforeach()
package(14.0.1 1)
file(WRITE "${WORK}/project/CMakeLists.txt" "cmake_minimum_required(VERSION 3.25)
  project(OgreChoice LANGUAGES NONE)
  include(\"${SOURCE}/LixelOgre.cmake\")
  list(APPEND CMAKE_PREFIX_PATH \${ALSO})
  lixel_find_ogre(\${EXACTLY})\n")

foreach(version 1.12.10 13.6.5 14.5.2)
  start_anew()
  expect("the folder asked for" "Lixel: OGRE ${version}, found in ${WORK}/${version}/lib/OGRE/cmake"
         "-DOGRE_DIR=${WORK}/${version}/lib/OGRE/cmake" "-DCMAKE_PREFIX_PATH=${WORK}/1.12.9")
  start_anew()
  expect("the prefix asked for" "Lixel: OGRE ${version}, found in ${WORK}/${version}/lib/OGRE/cmake"
         "-DCMAKE_PREFIX_PATH=${WORK}/${version}")
endforeach()
# The last one was 14.5.2.
expect("another prefix later" "Lixel: OGRE 13.6.5, found" "-DCMAKE_PREFIX_PATH=${WORK}/13.6.5")
expect("another folder later" "Lixel: OGRE 1.12.10, found"
       "-DOGRE_DIR=${WORK}/1.12.10/lib/OGRE/cmake" "-DCMAKE_PREFIX_PATH=${WORK}/14.5.2")

start_anew()
expect("a folder without OGRE" "OGRE_DIR is ${WORK}/nowhere, and there is no usable"
       "-DOGRE_DIR=${WORK}/nowhere" "-DCMAKE_PREFIX_PATH=${WORK}/14.5.2")
foreach(version 1.12.9 15.0.0)
  start_anew()
  expect("another version" "OGRE ${version} in .* will not do: it has to be one of 1.12.10 to 14.x"
         "-DCMAKE_PREFIX_PATH=${WORK}/${version}")
endforeach()
start_anew()
expect("double precision" "OGRE 14.0.1 in .* was built in double precision"
       "-DCMAKE_PREFIX_PATH=${WORK}/14.0.1")
# As the installed package asks.
start_anew()
expect("the version of the build" "Lixel: OGRE 14.5.2, found" -DEXACTLY=14.5.2
       "-DCMAKE_PREFIX_PATH=${WORK}/13.6.5" "-DALSO=${WORK}/14.5.2")
start_anew()
expect("another version than the build's" "exactly matches requested version \"14.5.1\""
       -DEXACTLY=14.5.1 "-DCMAKE_PREFIX_PATH=${WORK}/14.5.2")
