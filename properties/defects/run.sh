#!/usr/bin/env bash
# Plants a defect in a copy of core's headers, and expects the law that the patch names to notice.
#
#   run.sh CONFIG PATCH     exit 0: the patch applied, core compiled, and the law broke
#   run.sh CONFIG --none    exit 0: without a patch every law that a patch names holds
#   run.sh CONFIG --covered exit 0: every law has a patch that names it
#   run.sh CONFIG --matrix  every patch against every law of its kind (minutes; not a test)
#
# A linear law sees $cases cases, a rotating one $turning_cases of its own (driver.cpp).
# A patch begins with lines "Defect: what is wrong" and "Law: who notices". CONFIG is written by CMake: the
# compiler, its flags, and what to link; only the files that instantiate core are compiled again: of rotating
# casts where the law is one of theirs, of linear ones else.
set -euo pipefail
config=$1
what=$2
here=$(cd "$(dirname "$0")" && pwd)
# shellcheck source=/dev/null
source "$config"
cases=2000
turning_cases=240
extra=()

law_of() { sed -n 's/^Law: //p' "$1"; }
# The laws of rotating casts stand in one file, by name.
is_turning() { grep -q "{\"$1\"," "$here/../laws_rotating.cpp"; }
cases_for() { if is_turning "$1"; then echo "$turning_cases"; else echo "$cases"; fi; }

# compile CORE DIR FILE...: methods of the library against other headers of core, one object each.
compile() {
  local core=$1 to=$2
  shift 2
  for file in "$@"; do
    # Not through a compiler cache: the copy has a new path in every run.
    "$GRAZE_CXX" "${GRAZE_FLAGS[@]}" "${extra[@]}" -I"$core" "${GRAZE_INCLUDES[@]}" -c "$file" \
      -o "$to/$(basename "$file" .cpp).o"
  done
  "$GRAZE_CXX" "$to"/*.o "${GRAZE_LINK[@]}" -o "$to/driver"
}

# build PATCH DIR: a driver whose methods carry the defect; in double alone, unless the patch speaks of float.
build() {
  extra=()
  grep -q float "$1" || extra=(-DGRAZE_DOUBLE_ALONE)
  mkdir -p "$2/core"
  cp -r "$GRAZE_CORE/graze" "$2/core/graze"
  if ! patch --quiet --strip=2 --fuzz=3 --directory="$2/core" <"$1" >"$2/patch.log" 2>&1; then
    cat "$2/patch.log"
    echo "FAIL: $(basename "$1") does not apply to core any more; make it again"
    exit 1
  fi
  if is_turning "$(law_of "$1")"; then
    compile "$2/core" "$2" "$GRAZE_ROTATING_METHODS"
  else
    compile "$2/core" "$2" "$GRAZE_METHODS"
  fi
}

case $what in
  --none)
    # The same build, of an unpatched copy.
    scratch=$(mktemp -d)
    trap 'rm -rf "$scratch"' EXIT
    mkdir -p "$scratch/none"
    cp -r "$GRAZE_CORE" "$scratch/none/core"
    compile "$scratch/none/core" "$scratch" "$GRAZE_METHODS" "$GRAZE_ROTATING_METHODS"
    "$scratch/driver" --all "$cases" || { echo "FAIL: a law is broken without any defect"; exit 1; }
    "$scratch/driver" --all-turning "$turning_cases" || { echo "FAIL: a law is broken without any defect"; exit 1; }
    echo "every law holds on $cases cases, of rotating casts on $turning_cases, without a defect"
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
      if is_turning "$(law_of "$one")"; then
        "$scratch/driver" --all-turning "$turning_cases" || true
      else
        "$scratch/driver" --all "$cases" || true
      fi
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
    "$scratch/driver" "$law" "$(cases_for "$law")" || status=$?
    if [[ $status -ne 1 ]]; then
      echo "FAIL: $law did not notice $(basename "$what" .patch) (exit $status)"
      exit 1
    fi
    echo "$law noticed $(basename "$what" .patch)"
    ;;
esac
