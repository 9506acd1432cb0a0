# Options, and the settings of our own targets. Nothing here reaches a consumer: warnings and flags live on
# graze_own, an INTERFACE target that only our own binaries link.
option(GRAZE_TOOLS "Build the judge and the graze command (CGAL: GPL)" ${PROJECT_IS_TOP_LEVEL})
option(GRAZE_TESTS "Build the tests" ${PROJECT_IS_TOP_LEVEL})
option(GRAZE_BENCH "Build the benchmarks (Google Benchmark)" OFF)
option(GRAZE_WERROR "Warnings are errors in our own targets" OFF)
option(GRAZE_ASSERTIONS "Core checks what it relies on (core/graze/linkage.hpp): for tests and fuzzing" OFF)
set(GRAZE_SANITIZE "" CACHE STRING "Sanitizers for our own targets, e.g. address,undefined")

if(PROJECT_IS_TOP_LEVEL)
  if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
    set(CMAKE_BUILD_TYPE Release CACHE STRING "" FORCE)
  endif()
  find_program(GRAZE_CCACHE ccache)
  if(GRAZE_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
    set(CMAKE_CXX_COMPILER_LAUNCHER ${GRAZE_CCACHE})
  endif()
  set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
endif()

add_library(graze_own INTERFACE)
target_compile_features(graze_own INTERFACE cxx_std_20)
# Our results must not depend on whether a multiply-add was fused; users of core may do as they like.
target_compile_options(graze_own INTERFACE -ffp-contract=off -Wall -Wextra -Wpedantic -Wshadow -Wconversion
                                           -Wno-sign-conversion)
target_include_directories(graze_own INTERFACE ${PROJECT_SOURCE_DIR})
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  # g++ 12 drops the rounding of double(float(x)) on neighbouring doubles when it packs them (seen at -O2 and -O3), and
  # warns falsely of overlap in "x" + std::string (GCC 105651).
  target_compile_options(graze_own INTERFACE -fno-tree-slp-vectorize -Wno-restrict)
endif()
if(GRAZE_WERROR)
  target_compile_options(graze_own INTERFACE -Werror)
endif()
if(GRAZE_SANITIZE)
  target_compile_options(graze_own INTERFACE -fsanitize=${GRAZE_SANITIZE} -fno-omit-frame-pointer)
  target_link_options(graze_own INTERFACE -fsanitize=${GRAZE_SANITIZE})
endif()
