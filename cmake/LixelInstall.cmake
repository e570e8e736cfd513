# What `cmake --install` installs, for applications that say find_package(Lixel):
#
#   include/Lixel/ROOM/Header.h        the public headers, included as <Lixel/ROOM/Header.h>
#   lib/libLixel.so                    target Lixel::Lixel
#   lib/libLixelHeadless.so            target Lixel::Headless
#   lib/libLixelRTSS.so                target Lixel::RTSS
#   lib/OGRE/Plugin_Lixel.so           what plugins.cfg names
#   lib/OGRE/Plugin_LixelCg.so         programs in Cg and HLSL, which works alone
#   bin/lixel-shaderc                  prints what they are translated to
#   lib/cmake/Lixel/                   the package's configuration
#   share/Lixel/materials/             scripts and programs (materials/CMakeLists.txt)
#   share/Lixel/{plugins,resources}.cfg  the entries that an application needs, to copy
#   share/doc/Lixel/                   the users' READMEs and a whole program
#
# The browser is not installed: it reads the plugins.cfg and resources.cfg of the build tree.

include(CMakePackageConfigHelpers)

set(LIXEL_INSTALL_PLUGINS "${CMAKE_INSTALL_LIBDIR}/OGRE")
set(LIXEL_INSTALL_PACKAGE "${CMAKE_INSTALL_LIBDIR}/cmake/Lixel")
set(LIXEL_INSTALL_SHARE "${CMAKE_INSTALL_DATADIR}/Lixel")

# Users of the headers need C++20 as well; the export set tells their compiler.
target_compile_features(Lixel INTERFACE cxx_std_20)
# The plugin finds libLixel in the folder above, wherever the prefix is.
set_target_properties(Plugin_Lixel PROPERTIES INSTALL_RPATH "$ORIGIN/..")

install(TARGETS Lixel LixelHeadless EXPORT LixelTargets
  LIBRARY DESTINATION "${CMAKE_INSTALL_LIBDIR}")
if(LIXEL_BUILD_RTSS)
  set_target_properties(LixelRTSS PROPERTIES INSTALL_RPATH "$ORIGIN")
  install(TARGETS LixelRTSS EXPORT LixelTargets LIBRARY DESTINATION "${CMAKE_INSTALL_LIBDIR}")
endif()
install(TARGETS Plugin_Lixel LIBRARY DESTINATION "${LIXEL_INSTALL_PLUGINS}")
if(LIXEL_BUILD_CG)
  install(TARGETS Plugin_LixelCg LIBRARY DESTINATION "${LIXEL_INSTALL_PLUGINS}")
  if(LIXEL_BUILD_SAMPLES)
    install(TARGETS lixel-shaderc RUNTIME DESTINATION "${CMAKE_INSTALL_BINDIR}")
  endif()
endif()
# What users need, and what these headers include.
set(public_headers
  fit/geometry/BoxSet.h
  fit/geometry/HalfSpace.h
  fit/geometry/SurfaceCloud.h
  fit/geometry/Types.h
  fit/problem/Option.h
  fit/problem/ShadowFit.h
  fit/problem/ShadowPart.h
  fit/problem/ShadowProblem.h
  fit/problem/Technique.h
  fit/problem/TexelInPixels.h
  fit/parts/CascadeSplits.h
  setup/CascadesShadowCameraSetup.h
  setup/Detach.h
  setup/FittedShadowCameraSetup.h
  setup/MeshPreparation.h
  setup/ObservedShadowCameraSetup.h
  setup/PlaneOptimalShadowCameraSetup.h
  setup/PostProjectiveCubeShadowCameraSetup.h
  setup/SetupList.h
  setup/ShadowCameraSetups.h
  setup/MapBudget.h
  setup/MapPlan.h
  setup/ShadowMapObserver.h
  setup/TechniqueShadowCameraSetup.h
  setup/VisiblePointFeedback.h
  material/ShadowMaterials.h
  material/ShadowParameters.h
  script/PresetSettings.h
  script/ShadowCameraSetupManager.h
  script/ShadowPreset.h
  reload/Reload.h
  scene/OgreVersions.h
  manager/LixelSceneManager.h
  headless/Headless.h)
if(LIXEL_BUILD_RTSS)
  list(APPEND public_headers rtss/ShaderSystem.h)
endif()
# Each technique's options.
file(GLOB techniques CONFIGURE_DEPENDS RELATIVE "${PROJECT_SOURCE_DIR}/plugin"
  "${PROJECT_SOURCE_DIR}/plugin/fit/technique/*.h")
foreach(header ${public_headers} ${techniques})
  get_filename_component(room "${header}" DIRECTORY)
  install(FILES "${PROJECT_SOURCE_DIR}/plugin/${header}"
    DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}/Lixel/${room}")
endforeach()

# What to read, and a whole program.
foreach(document README.md materials/README.md tests/install/application/main.cpp
    tests/install/application/CMakeLists.txt tests/install/shader_system/main.cpp
    tests/install/shader_system/CMakeLists.txt)
  get_filename_component(folder "${document}" DIRECTORY)
  install(FILES "${PROJECT_SOURCE_DIR}/${document}"
    DESTINATION "${CMAKE_INSTALL_DATADIR}/doc/Lixel/${folder}")
endforeach()

install(EXPORT LixelTargets NAMESPACE Lixel:: DESTINATION "${LIXEL_INSTALL_PACKAGE}")
configure_package_config_file(
  "${CMAKE_CURRENT_LIST_DIR}/LixelConfig.cmake.in" "${PROJECT_BINARY_DIR}/LixelConfig.cmake"
  INSTALL_DESTINATION "${LIXEL_INSTALL_PACKAGE}"
  PATH_VARS LIXEL_INSTALL_PLUGINS LIXEL_INSTALL_SHARE)
write_basic_package_version_file(
  "${PROJECT_BINARY_DIR}/LixelConfigVersion.cmake" COMPATIBILITY SameMinorVersion)
install(FILES
  "${PROJECT_BINARY_DIR}/LixelConfig.cmake"
  "${PROJECT_BINARY_DIR}/LixelConfigVersion.cmake"
  "${CMAKE_CURRENT_LIST_DIR}/LixelOgre.cmake"
  DESTINATION "${LIXEL_INSTALL_PACKAGE}")

# plugins.cfg and resources.cfg name the prefix, which is known for sure only when installing
# (`cmake --install --prefix`), so they are written then.
install(CODE "
  set(source \"${CMAKE_CURRENT_LIST_DIR}\")
  set(generated \"${PROJECT_BINARY_DIR}/installed\")
  set(LIXEL_CFG_OGRE_PLUGINS \"${OGRE_PLUGIN_DIR}\")
  set(LIXEL_CFG_OGRE_SHADOWS \"${LIXEL_OGRE_SHADOW_MEDIA}\")
  set(LIXEL_CFG_PLUGIN \"\${CMAKE_INSTALL_PREFIX}/${LIXEL_INSTALL_PLUGINS}/Plugin_Lixel.so\")
  set(LIXEL_CFG_CG_PLUGIN
      \"\${CMAKE_INSTALL_PREFIX}/${LIXEL_INSTALL_PLUGINS}/Plugin_LixelCg.so\")
  set(LIXEL_CFG_MATERIALS \"\${CMAKE_INSTALL_PREFIX}/${LIXEL_INSTALL_SHARE}/materials\")
  foreach(file plugins.cfg resources.cfg)
    configure_file(\"\${source}/\${file}.in\" \"\${generated}/\${file}\" @ONLY)
    file(INSTALL \"\${generated}/\${file}\"
         DESTINATION \"\${CMAKE_INSTALL_PREFIX}/${LIXEL_INSTALL_SHARE}\")
  endforeach()
")
