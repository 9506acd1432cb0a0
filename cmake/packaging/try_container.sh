#!/usr/bin/env bash
# Runs the steps of the Containerfile as root in fresh systems that mmdebstrap makes, without podman. The last one then runs
# the command. CMAKE_BUILD_PARALLEL_LEVEL limits the build. usage: try_container.sh [ARGUMENTS OF graze]
set -euo pipefail
cd "$(dirname "$0")/../.."
work=$(mktemp -d)
trap 'rm -rf --one-file-system "$work"' EXIT
(($#)) || set -- certify --family random --count 20

# What is mounted is gone with the process that it was mounted for.
inside() {
  unshare --mount bash -c 'root=$1 folder=$2; shift 2
    mount -t proc proc "$root/proc" && mount --rbind /dev "$root/dev"
    exec chroot "$root" sh -c "cd $folder && \"\$@\"" sh "$@"' bash "$root" "$folder" "$@"
}

while read -r instruction rest; do
  [[ -z $instruction || $instruction == \#* ]] || printf '== %s %s\n' "$instruction" "$rest"
  read -r first second third <<<"$rest"
  case $instruction in
    '' | \#*) ;;
    FROM)
      [[ $first == debian:12 ]]
      root=$work/${third:-last} folder=/
      mmdebstrap --variant=minbase --quiet bookworm "$root"
      cp /etc/resolv.conf "$root/etc/"
      ;;
    WORKDIR)
      folder=$first
      mkdir -p "$root$folder"
      ;;
    COPY)
      if [[ $first == --from=* ]]; then
        mkdir -p "$root$third"
        cp -r "$work/${first#--from=}$second." "$root$third"
      else
        git ls-files -z --cached --others --exclude-standard | xargs -0 cp --parents -t "$root$folder"
      fi
      ;;
    RUN) inside env DEBIAN_FRONTEND=noninteractive sh -c "$rest" ;;
    ENTRYPOINT) entry=$(tr -d '[]",' <<<"$rest") ;;
    *) echo "unknown instruction: $instruction" && exit 1 ;;
  esac
done <Containerfile
echo "== $entry $*"
inside "$entry" "$@"
