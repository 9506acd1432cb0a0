// Which graze this translation unit sees. Both have the same files and the same answers.
//
//   graze::core   header-only: a public header brings its definitions.
//   graze::graze  compiled for float and double: the public headers only declare, and the CMake target
//   defines
//                 GRAZE_COMPILED.
// The two are in namespaces of their own, both inline, so that one program may hold both.
#pragma once

#if (defined(_MSVC_LANG) ? _MSVC_LANG : __cplusplus) < 202002L
#include "graze needs C++20: compile with -std=c++20 (CMake: target_link_libraries asks for it)"
#endif

#ifdef GRAZE_COMPILED
#define GRAZE_LINKAGE compiled
#else
#define GRAZE_LINKAGE header_only
#endif
