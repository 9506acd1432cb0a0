#!/usr/bin/env bash
# Installs graze as somebody does who has Eigen and a compiler, and looks at what is there: the headers, the compiled
# library, the package. At -O1, which compiles in half the time; with -O3 the same sources are in every other test.
# usage: install.sh SETTINGS
set -euo pipefail
source "$1"
build="$scratch/core" prefix="$scratch/prefix" small="$scratch/small"
rm -rf "$build" "$prefix" "$small"
# configure BUILD [OPTION...]
configure() {
  "$cmake" -S "$source_dir" -B "$1" -DCMAKE_CXX_COMPILER_LAUNCHER="$launcher" --no-warn-unused-cli -DGRAZE_TOOLS=OFF -DGRAZE_TESTS=OFF \
    -DCMAKE_CXX_FLAGS_RELEASE="-O1 -DNDEBUG" -DCMAKE_CXX_COMPILER="$cxx" -DEigen3_DIR="$eigen_dir" "${without[@]}" "${@:2}" \
    >"$1.log" 2>&1
}
configure "$build" || { cat "$build.log"; exit 1; }
# GRAZE_SCENE=OFF leaves out the scene, and the judge says that it needs one.
configure "$small" -DGRAZE_SCENE=OFF || { cat "$small.log"; exit 1; }
"$cmake" --build "$small" --target help >"$small.targets"
grep -qw graze "$small.targets" || { echo "GRAZE_SCENE=OFF: there is no library to build"; exit 1; }
! grep graze_scene "$small.targets" || { echo "GRAZE_SCENE=OFF: the scene is built"; exit 1; }
! grep -r "graze-scene" --include=cmake_install.cmake "$small" || { echo "GRAZE_SCENE=OFF: the scene is installed"; exit 1; }
! configure "$small" -DGRAZE_SCENE=OFF -DGRAZE_TOOLS=ON || { echo "GRAZE_SCENE=OFF is accepted with GRAZE_TOOLS=ON"; exit 1; }
grep -q "GRAZE_TOOLS needs GRAZE_SCENE" "$small.log" || { cat "$small.log"; exit 1; }
"$cmake" --build "$build" -j2 >>"$build.log" 2>&1 || { cat "$build.log"; exit 1; }
"$cmake" --install "$build" --prefix "$prefix" >>"$build.log"
# Every header of core and of scene, and nothing from another room.
diff <(for room in core scene; do (cd "$source_dir/$room" && find graze -name "*.hpp"); done | sort) \
  <(cd "$prefix/include" && find . -type f | sed 's|^\./||' | sort)
others=$(cd "$prefix" && find . -type f -not -path './include/graze/*' | sort | tr '\n' ' ')
expected='./lib/cmake/graze/graze-config-version.cmake ./lib/cmake/graze/graze-config.cmake ./lib/cmake/graze/graze-scene-targets-release.cmake ./lib/cmake/graze/graze-scene-targets.cmake ./lib/cmake/graze/graze-targets-release.cmake ./lib/cmake/graze/graze-targets.cmake ./lib/libgraze.a ./lib/libgraze_scene.a ./lib/pkgconfig/graze-core.pc ./lib/pkgconfig/graze-scene.pc ./lib/pkgconfig/graze.pc ./share/doc/graze/LICENSE '
[[ $others == "$expected" ]] || { echo "installed beside the headers: $others"; exit 1; }
# It can be moved: no path of this machine is in it.
! grep -rnF -e "$source_dir" -e "$scratch" "$prefix" || { echo "an installed file names the build's folders"; exit 1; }
echo "$(find "$prefix/include" -type f | wc -l) headers installed"
