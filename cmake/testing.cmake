# graze_test(name LABELS l... SOURCES s... LIBRARIES l...): one GoogleTest executable, its cases known to ctest.
find_package(GTest REQUIRED)
include(GoogleTest)

graze_precompiled(graze_test_headers LIBRARIES graze::corpus GTest::gtest
  HEADERS <gtest/gtest.h> <algorithm> <cmath> <functional> <string> <vector> ${PROJECT_SOURCE_DIR}/corpus/case.hpp)

function(graze_test name)
  cmake_parse_arguments(arg "" "" "LABELS;SOURCES;LIBRARIES" ${ARGN})
  add_executable(${name} ${arg_SOURCES})
  target_link_libraries(${name} PRIVATE graze_own ${arg_LIBRARIES} GTest::gtest_main)
  graze_precompile(${name} graze_test_headers)
  target_compile_options(${name} PRIVATE ${GRAZE_COLD})
  target_compile_definitions(${name} PRIVATE GRAZE_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
  gtest_discover_tests(${name} DISCOVERY_MODE PRE_TEST PROPERTIES LABELS "${arg_LABELS}")
endfunction()
