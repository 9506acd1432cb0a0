/// @file
/// Which graze this translation unit uses: header-only or compiled. Both have the same files and the same answers.
///
/// - `graze::core` is header-only: a public header brings its definitions.
/// - `graze::graze` is compiled for float and double: the public headers only declare, and the CMake target defines
///   GRAZE_COMPILED.
///
/// The two are in inline namespaces of their own, so one program may hold both.
///
/// If GRAZE_ASSERTIONS is defined, functions check what they rely on, and a broken invariant ends the program with
/// one line. Define GRAZE_ASSERTION_FAILED(text, file, line), the same in every file, to do something else. CMake's
/// option of that name defines it for our tests and fuzzers. Users do not need it.
//
// Assertions stand behind the public headers only. So a compiled library holds its own, whatever its user defines. Headers
// that assert are in a namespace of their own, so that files with and without may be linked together.
#pragma once

#if (defined(_MSVC_LANG) ? _MSVC_LANG : __cplusplus) < 202002L
#include "graze needs C++20: compile with -std=c++20 (CMake: target_link_libraries asks for it)"
#endif

/// @cond
#ifdef GRAZE_COMPILED
#define GRAZE_LINKAGE compiled
#elif defined(GRAZE_ASSERTIONS)
#define GRAZE_LINKAGE header_only_asserting
#else
#define GRAZE_LINKAGE header_only
#endif

// States a precondition of a function, or an assumption of an algorithm. It never checks input, which is the task of
// validate(). Without GRAZE_ASSERTIONS it is compiled, and not evaluated.
#ifdef GRAZE_ASSERTIONS
#ifndef GRAZE_ASSERTION_FAILED
#include <cstdio>
#include <cstdlib>

namespace graze { inline namespace GRAZE_LINKAGE { namespace detail {
[[noreturn]] inline void assertion_failed(const char* text, const char* file, int line) {
  std::fprintf(stderr, "%s:%d: graze relies on %s\n", file, line, text);
  std::abort();
}
}}}  // namespace graze::GRAZE_LINKAGE::detail
#define GRAZE_ASSERTION_FAILED(text, file, line) ::graze::detail::assertion_failed(text, file, line)
#endif
#define GRAZE_ASSERT(...) \
  ((__VA_ARGS__) ? static_cast<void>(0) : GRAZE_ASSERTION_FAILED(#__VA_ARGS__, __FILE__, __LINE__))
#else
#define GRAZE_ASSERT(...) static_cast<void>(sizeof((__VA_ARGS__) ? 1 : 0))
#endif
/// @endcond
