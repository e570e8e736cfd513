# lixel_discover_tests(TARGET LABEL [FILTER]): tells CTest of a GoogleTest program's suites.
#
# A suite is one test of CTest: its tests share a process. Most of Lixel's tests need OGRE, and
# starting it takes longer than they do. One test is run by hand: TARGET --gtest_filter=Suite.Test
#
# FILTER: as of --gtest_filter, which suites there are; default all.
set(LIXEL_LIST_SUITES "${CMAKE_CURRENT_LIST_DIR}/ListSuites.cmake")

function(lixel_discover_tests target label)
  set(filter "*")
  if(ARGC GREATER 2)
    set(filter "${ARGV2}")
  endif()
  set(list "${CMAKE_CURRENT_BINARY_DIR}/${target}_suites.cmake")
  add_custom_command(TARGET ${target} POST_BUILD
    BYPRODUCTS "${list}"
    COMMAND "${CMAKE_COMMAND}"
      -D "PROGRAM=$<TARGET_FILE:${target}>" -D "LABEL=${label}" -D "FILTER=${filter}"
      -D "LIST=${list}" -P "${LIXEL_LIST_SUITES}"
    VERBATIM)
  # Until the program is built, its test says so and fails.
  set(found "${CMAKE_CURRENT_BINARY_DIR}/${target}_found.cmake")
  file(WRITE "${found}"
    "if(EXISTS \"${list}\")\n  include(\"${list}\")\n"
    "else()\n  add_test(${target}_NOT_BUILT ${target}_NOT_BUILT)\n"
    "  set_tests_properties(${target}_NOT_BUILT PROPERTIES LABELS ${label})\nendif()\n")
  set_property(DIRECTORY APPEND PROPERTY TEST_INCLUDE_FILES "${found}")
endfunction()
