# Options, and the settings of our own targets. Nothing here reaches a consumer: warnings and flags live on
# graze_own, an INTERFACE target that only our own binaries link.
option(GRAZE_SCENE "Build graze::scene, many bodies over a step (it needs GRAZE_LIBRARY)" ON)
option(GRAZE_TOOLS "Build the judge and the graze command (CGAL: GPL)" ${PROJECT_IS_TOP_LEVEL})
option(GRAZE_TESTS "Build the tests" ${PROJECT_IS_TOP_LEVEL})
option(GRAZE_BENCH "Build the benchmarks (Google Benchmark)" OFF)
option(GRAZE_ZOO "Build the programs that put other engines under the judge, where their packages are" OFF)
option(GRAZE_WERROR "Warnings are errors in our own targets" OFF)
option(GRAZE_PCH "Compile our own files with precompiled headers; OFF: each stands by itself" ${PROJECT_IS_TOP_LEVEL})
if(GRAZE_FUZZ)  # What leads a fuzzer is instrumented, library by library, and a header compiled for several would not be.
  set(GRAZE_PCH OFF)
endif()
option(GRAZE_UNITY "Compile many small files of ours at once: sooner from nothing, later after an edit" OFF)
option(GRAZE_ASSERTIONS "Core checks what it relies on (core/graze/linkage.hpp): for tests and fuzzing" OFF)
set(GRAZE_SANITIZE "" CACHE STRING "Sanitizers for our own targets, e.g. address,undefined")

if(GRAZE_TOOLS AND NOT GRAZE_SCENE)
  message(FATAL_ERROR "GRAZE_TOOLS needs GRAZE_SCENE. Set GRAZE_SCENE=ON, or GRAZE_TOOLS=OFF.")
endif()

# cmake/install_judge.cmake has the other component, the command.
set(CMAKE_INSTALL_DEFAULT_COMPONENT_NAME library)

if(PROJECT_IS_TOP_LEVEL)
  if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
    set(CMAKE_BUILD_TYPE Release CACHE STRING "" FORCE)
  endif()
  # GRAZE_LAUNCHER: one program before the compiler, for scripts that compile.
  set(GRAZE_LAUNCHER "${CMAKE_CXX_COMPILER_LAUNCHER}")
  find_program(GRAZE_CCACHE ccache)
  if(GRAZE_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
    set(GRAZE_LAUNCHER ${GRAZE_CCACHE})
    # What ccache must overlook to know a file again that is compiled with a precompiled header.
    set(CMAKE_CXX_COMPILER_LAUNCHER ${CMAKE_COMMAND} -E env CCACHE_SLOPPINESS=pch_defines,time_macros ${GRAZE_CCACHE})
  endif()
  set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
endif()

# The flag that keeps a multiply and an add apart: results must not depend on whether they were fused.
if(MSVC)  # cl keeps them apart under /fp:precise, its default; clang-cl takes the flag of clang
  set(GRAZE_UNFUSED /fp:precise $<$<CXX_COMPILER_ID:Clang>:/clang:-ffp-contract=off>)
else()
  include(CheckCXXCompilerFlag)
  check_cxx_compiler_flag(-ffp-contract=off GRAZE_HAS_FP_CONTRACT)
  if(GRAZE_HAS_FP_CONTRACT)
    set(GRAZE_UNFUSED -ffp-contract=off)
  endif()
endif()

# The flags of the compiled libraries. g++ 12 drops the rounding of double(float(x)) on neighbouring doubles when it packs
# them (seen at -O2 and -O3). A superproject without a build type gets optimised libraries.
function(graze_compile_for_casts target)
  target_compile_options(${target} PRIVATE ${GRAZE_UNFUSED} $<$<CXX_COMPILER_ID:GNU>:-fno-tree-slp-vectorize>)
  if(NOT MSVC)
    target_compile_options(${target} PRIVATE $<$<CONFIG:>:-O2>)
  endif()
endfunction()

add_library(graze_own INTERFACE)
target_compile_features(graze_own INTERFACE cxx_std_20)
# Our results must not depend on whether a multiply-add was fused; users of core may do as they like, and so do the targets
# with the property GRAZE_CONTRACTED (their own flags come before these, so none of theirs could take this one back).
target_compile_options(graze_own INTERFACE "$<$<NOT:$<BOOL:$<TARGET_PROPERTY:GRAZE_CONTRACTED>>>:${GRAZE_UNFUSED}>")
target_include_directories(graze_own INTERFACE ${PROJECT_SOURCE_DIR})
if(MSVC)
  target_compile_options(graze_own INTERFACE /W4 /wd4068 /wd5030)  # no warnings about other compilers' pragmas and attributes
else()
  target_compile_options(graze_own INTERFACE -Wall -Wextra -Wpedantic -Wconversion -Wno-sign-conversion)
  # Where several sources are compiled at once, a file's local names hide another file's, and are none of a header's.
  set(united $<AND:$<BOOL:$<TARGET_PROPERTY:UNITY_BUILD>>,$<CXX_COMPILER_ID:GNU>>)
  target_compile_options(graze_own INTERFACE $<IF:${united},-Wshadow=local;-Wno-subobject-linkage,-Wshadow>)
  # Where assertions are on, what we install holds names of files: as the sources name them, not where they were built.
  target_compile_options(graze_own INTERFACE -ffile-prefix-map=${PROJECT_SOURCE_DIR}/=)
  if(GRAZE_WERROR)
    target_compile_options(graze_own INTERFACE -Werror)
  endif()
  if(GRAZE_SANITIZE)
    target_compile_options(graze_own INTERFACE -fsanitize=${GRAZE_SANITIZE} -fno-omit-frame-pointer)
    target_link_options(graze_own INTERFACE -fsanitize=${GRAZE_SANITIZE})
  endif()
endif()
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  # g++ 12 drops the rounding of double(float(x)) on neighbouring doubles when it packs them (seen at -O2 and -O3), and
  # warns falsely of overlap and bounds in "x" + std::string (GCC 105651, 105329).
  target_compile_options(graze_own INTERFACE -fno-tree-slp-vectorize -Wno-restrict -Wno-array-bounds -Wno-stringop-overflow
                                            -Wno-stringop-overread)
endif()
# What is not called a million times a second (commands, reports, tests' own files) need not be compiled to be. It is added
# to a target after the -O3 of a release build, whose place it takes.
set(GRAZE_COLD $<$<CONFIG:Release>:-O1>)
set(GRAZE_WARM $<$<CONFIG:Release>:-O2>)  # oracles: the judge spends its time there, and in core, which has -O3

# Of a file that would take more than 1.2 GB to compile: g++ collects its garbage sooner, for at most a quarter of the time.
set(GRAZE_SPARING $<$<CXX_COMPILER_ID:GNU>:--param=ggc-min-expand=30>)

# graze_precompiled(name OPTIMIZED o LIBRARIES l... HEADERS h...): headers that most files of some targets include, compiled
# once for them all; graze_precompile(target name) makes a target use them. Nothing of it decides what a file may use: with
# GRAZE_PCH=OFF each stands by itself, and a test of `./run check` compiles them so. g++ optimises a file as the precompiled
# header that it uses was, and overlooks an -O1 of the file's own (seen with g++ 12): so o is said once, with the headers.
function(graze_precompiled name)
  cmake_parse_arguments(arg "" "OPTIMIZED" "LIBRARIES;HEADERS" ${ARGN})
  set_property(GLOBAL PROPERTY GRAZE_OPTIMIZED_${name} "${arg_OPTIMIZED}")
  if(NOT GRAZE_PCH)
    return()
  endif()
  set(nothing ${CMAKE_CURRENT_BINARY_DIR}/${name}.cpp)
  file(CONFIGURE OUTPUT ${nothing} CONTENT "// The precompiled headers belong to this.\n")
  add_library(${name} OBJECT ${nothing})
  target_link_libraries(${name} PRIVATE graze_own ${arg_LIBRARIES})
  target_compile_options(${name} PRIVATE ${arg_OPTIMIZED})
  # Not from ccache: it knows files by what is in them, and a precompiled header by when they were written.
  set_target_properties(${name} PROPERTIES CXX_COMPILER_LAUNCHER "")
  target_precompile_headers(${name} PRIVATE ${arg_HEADERS})
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    target_compile_options(${name} PRIVATE -fpch-preprocess)  # for ccache
  endif()
endfunction()
function(graze_precompile target name)
  get_property(optimized GLOBAL PROPERTY GRAZE_OPTIMIZED_${name})
  target_compile_options(${target} PRIVATE ${optimized})
  if(NOT GRAZE_PCH)
    return()
  endif()
  target_precompile_headers(${target} REUSE_FROM ${name})
  # A compiler refuses precompiled headers that had definitions which the file has not.
  target_compile_definitions(${target} PRIVATE $<TARGET_PROPERTY:${name},COMPILE_DEFINITIONS>)
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    target_compile_options(${target} PRIVATE -fpch-preprocess)
  endif()
endfunction()

# The many small files of a room, ten at a time, where GRAZE_UNITY says so. FOLDERS f...: instead, those of each of these
# folders; the others, which include much, stay by themselves. PLANTED: not where tests are built, whose planted defects put
# an object of one file in the place of the library's.
function(graze_unite target)
  cmake_parse_arguments(arg "PLANTED" "" "FOLDERS" ${ARGN})
  if(arg_PLANTED AND GRAZE_TESTS)
    return()
  endif()
  set_target_properties(${target} PROPERTIES UNITY_BUILD ${GRAZE_UNITY} UNITY_BUILD_BATCH_SIZE 10)
  if(arg_FOLDERS)
    set_target_properties(${target} PROPERTIES UNITY_BUILD_MODE GROUP)
    get_target_property(sources ${target} SOURCES)
    foreach(source IN LISTS sources)
      cmake_path(GET source PARENT_PATH folder)
      if(folder IN_LIST arg_FOLDERS)
        set_source_files_properties(${source} PROPERTIES UNITY_GROUP ${folder})
      endif()
    endforeach()
  endif()
endfunction()
