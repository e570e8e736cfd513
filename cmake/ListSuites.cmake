# Writes a file that tells CTest of a GoogleTest program's suites: cmake -D PROGRAM=... -P this.
# @see LixelTests.cmake
execute_process(
  COMMAND "${PROGRAM}" --gtest_list_tests "--gtest_filter=${FILTER}"
  OUTPUT_VARIABLE listed RESULT_VARIABLE result TIMEOUT 120)
if(NOT result EQUAL 0)
  message(FATAL_ERROR "${PROGRAM} --gtest_list_tests: ${result}\n${listed}")
endif()

set(tests "")
string(REPLACE ";" "," listed "${listed}") # in the values of parameters
string(REPLACE "\n" ";" lines "${listed}")
foreach(line IN LISTS lines)
  # "Suite." or "Suite.  # TypeParam = ..."; a suite's tests are indented.
  if(line MATCHES "^([^ ]+)\\.( |$)")
    set(suite "${CMAKE_MATCH_1}")
    string(APPEND tests
      "add_test([==[${suite}]==] [==[${PROGRAM}]==] [==[--gtest_filter=${suite}.*]==] "
      "--gtest_brief=1)\n"
      "set_tests_properties([==[${suite}]==] PROPERTIES LABELS ${LABEL})\n")
  endif()
endforeach()
if(tests STREQUAL "")
  message(FATAL_ERROR "${PROGRAM} has no tests")
endif()
file(WRITE "${LIST}" "${tests}")
