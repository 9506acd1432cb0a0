#!/usr/bin/env bash
# Runs the archived command in a fresh Debian 12, installs both Debian packages there, compiles the README's first cast with
# pkg-config and with CMake, and runs the installed command. It needs root, or user namespaces.
# usage: try_deb.sh FOLDER_OF_PACKAGES
set -euo pipefail
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cp "$1"/* "$work"
awk '/^```cpp$/ {on = 1; next} /^```$/ {if (on) exit} on' "$(dirname "$0")/../../README.md" >"$work/cast.cpp"
cp "$(dirname "$0")/conan/test_package/CMakeLists.txt" "$work"
cat >"$work/try" <<'END'
set -ex
cd /try
tar -xf graze-*.tar.gz
graze-*/bin/graze certify --family random --count 20
export DEBIAN_FRONTEND=noninteractive
apt-get install -y --no-install-recommends ./libgraze-dev_*.deb g++ make cmake pkgconf >/dev/null
c++ -std=c++20 cast.cpp $(pkg-config --cflags --libs graze-scene) -o by_pkgconfig
cmake -S . -B build -DCASTS=cast.cpp >/dev/null
cmake --build build >/dev/null
./by_pkgconfig
build/cast
apt-get install -y --no-install-recommends ./graze_*.deb >/dev/null
cd /
graze --version
graze certify --family random --count 20
zcat /usr/share/man/man1/graze.1.gz | head -5
apt-get purge -y graze libgraze-dev >/dev/null
! find / -xdev -path /proc -prune -o -name '*graze*' -not -path '/try*' -print | grep .
END
mmdebstrap --variant=minbase --quiet --customize-hook="cp -r $work \"\$1/try\"" \
  --customize-hook='chroot "$1" sh /try/try' bookworm /dev/null
echo "both packages were installed, used and removed in a fresh Debian 12"
