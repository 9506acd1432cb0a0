# graze_test(name LABELS l... SOURCES s... LIBRARIES l... [STANDALONE] [CONTRACTED]): one GoogleTest executable, its cases
# known to ctest. STANDALONE: without the precompiled headers, for files with flags of their own. CONTRACTED: built as users
# may build core, for the machine at hand, multiply-adds fused; and subnormals are flushed (tests/shared/flushed.hpp).
find_package(GTest REQUIRED)
include(GoogleTest)

graze_precompiled(graze_test_headers OPTIMIZED ${GRAZE_COLD} LIBRARIES graze::corpus GTest::gtest
  HEADERS <gtest/gtest.h> <algorithm> <cmath> <functional> <string> <vector> ${PROJECT_SOURCE_DIR}/corpus/case.hpp)

# Core as users may build it. Such tests link it before the library as it is.
function(graze_contract target)
  set_target_properties(${target} PROPERTIES GRAZE_CONTRACTED ON)
  target_compile_definitions(${target} PRIVATE GRAZE_TEST_FLUSH)
  # g++ 12 takes its own AVX-512 intrinsics, and an empty optional, for used before they are set.
  target_compile_options(${target} PRIVATE -O2 -march=native -ffp-contract=fast -Wno-maybe-uninitialized)
endfunction()
set(core_sources certified standard exact shapes queries rotating)
list(TRANSFORM core_sources REPLACE "(.+)" "${PROJECT_SOURCE_DIR}/core/src/\\1.cpp")
add_library(graze_contracted_core OBJECT ${core_sources})
target_link_libraries(graze_contracted_core PRIVATE graze_own graze::graze)
graze_contract(graze_contracted_core)
set_target_properties(graze_contracted_core PROPERTIES UNITY_BUILD ${GRAZE_UNITY} UNITY_BUILD_BATCH_SIZE 2
                                                       UNITY_BUILD_CODE_AFTER_INCLUDE "#undef GRAZE_INSTANCES")

function(graze_test name)
  cmake_parse_arguments(arg "STANDALONE;CONTRACTED" "" "LABELS;SOURCES;LIBRARIES" ${ARGN})
  add_executable(${name} ${arg_SOURCES})
  target_link_libraries(${name} PRIVATE graze_own ${arg_LIBRARIES} GTest::gtest_main)
  if(arg_CONTRACTED)
    graze_contract(${name})
    target_link_libraries(${name} PRIVATE graze_contracted_core)
  elseif(arg_STANDALONE)
    target_compile_options(${name} PRIVATE ${GRAZE_COLD})
  else()
    graze_precompile(${name} graze_test_headers)
  endif()
  target_compile_definitions(${name} PRIVATE GRAZE_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
  gtest_discover_tests(${name} DISCOVERY_MODE PRE_TEST PROPERTIES LABELS "${arg_LABELS}")
endfunction()
