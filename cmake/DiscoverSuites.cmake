# Read by ctest when it starts: one test for each suite of a GoogleTest binary, so that what a suite's cases share is
# made once and not by 4,800 processes.
#
# marketgen_discover_suites(<binary> <prefix>) adds <prefix>.<suite>; see tests/CMakeLists.txt.
function(marketgen_discover_suites binary prefix)
  if(NOT EXISTS "${binary}")
    add_test("${prefix}.not_built" "${binary}")
    return()
  endif()
  execute_process(COMMAND "${binary}" --gtest_list_tests OUTPUT_VARIABLE listed RESULT_VARIABLE failed TIMEOUT 60)
  if(failed)
    message(FATAL_ERROR "${binary} does not list its tests: ${failed}")
  endif()
  # Suites begin a line and end in a full stop; their cases are indented.
  string(REGEX MATCHALL "(^|\n)[A-Za-z0-9_/]+\\." suites "${listed}")
  foreach(suite IN LISTS suites)
    string(REGEX REPLACE "\n|\\.$" "" suite "${suite}")
    add_test("${prefix}.${suite}" "${binary}" "--gtest_filter=${suite}.*")
    set_tests_properties("${prefix}.${suite}" PROPERTIES TIMEOUT 900 LABELS "${prefix}")
  endforeach()
endfunction()
