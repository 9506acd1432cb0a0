#!/usr/bin/env bash
# Plants a defect in a copy of core's headers, and expects the law that the patch names to notice.
#
#   run.sh CONFIG PATCH     exit 0: the patch applied, core compiled, and the law broke
#   run.sh CONFIG --none    exit 0: without a patch every law that a patch names holds
#   run.sh CONFIG --covered exit 0: every law has a patch that names it
#   run.sh CONFIG --matrix  every patch against every law (minutes; not a test)
#
# A patch begins with lines "Defect: what is wrong" and "Law: who notices". CONFIG is written by CMake: the
# compiler, its flags, and what to link; only the file that instantiates core is compiled again.
set -euo pipefail
config=$1
what=$2
here=$(cd "$(dirname "$0")" && pwd)
# shellcheck source=/dev/null
source "$config"
cases=2000

law_of() { sed -n 's/^Law: //p' "$1"; }

# build PATCH DIR: a driver whose methods carry the defect.
build() {
  mkdir -p "$2/core"
  cp -r "$GRAZE_CORE/graze" "$2/core/graze"
  if ! patch --quiet --strip=2 --fuzz=3 --directory="$2/core" <"$1" >"$2/patch.log" 2>&1; then
    cat "$2/patch.log"
    echo "FAIL: $(basename "$1") does not apply to core any more; make it again"
    exit 1
  fi
  # Not through a compiler cache: the copy has a new path in every run.
  "$GRAZE_CXX" "${GRAZE_FLAGS[@]}" -I"$2/core" "${GRAZE_INCLUDES[@]}" -c "$GRAZE_METHODS" -o "$2/methods.o"
  "$GRAZE_CXX" "$2/methods.o" "${GRAZE_LINK[@]}" -o "$2/driver"
}

case $what in
  --none)
    # The same build, of an unpatched copy.
    scratch=$(mktemp -d)
    trap 'rm -rf "$scratch"' EXIT
    mkdir -p "$scratch/none"
    cp -r "$GRAZE_CORE" "$scratch/none/core"
    "$GRAZE_CXX" "${GRAZE_FLAGS[@]}" -I"$scratch/none/core" "${GRAZE_INCLUDES[@]}" -c "$GRAZE_METHODS" \
      -o "$scratch/methods.o"
    "$GRAZE_CXX" "$scratch/methods.o" "${GRAZE_LINK[@]}" -o "$scratch/driver"
    "$scratch/driver" --all "$cases" || { echo "FAIL: a law is broken without any defect"; exit 1; }
    echo "every law holds on $cases cases without a defect"
    ;;
  --covered)
    missing=0
    for law in $("$GRAZE_DRIVER" --laws); do
      if ! grep -qx "Law: $law" "$here"/*.patch; then
        echo "FAIL: no planted defect names the law $law"
        missing=1
      fi
    done
    exit $missing
    ;;
  --matrix)
    for one in "$here"/*.patch; do
      scratch=$(mktemp -d)
      echo "$(basename "$one" .patch): $(sed -n 's/^Defect: //p' "$one")"
      build "$one" "$scratch"
      "$scratch/driver" --all "$cases" || true
      rm -rf "$scratch"
    done
    ;;
  *)
    law=$(law_of "$what")
    [[ -n $law ]] || { echo "FAIL: $what names no law"; exit 1; }
    scratch=$(mktemp -d)
    trap 'rm -rf "$scratch"' EXIT
    build "$what" "$scratch"
    status=0
    "$scratch/driver" "$law" "$cases" || status=$?
    if [[ $status -ne 1 ]]; then
      echo "FAIL: $law did not notice $(basename "$what" .patch) (exit $status)"
      exit 1
    fi
    echo "$law noticed $(basename "$what" .patch)"
    ;;
esac
