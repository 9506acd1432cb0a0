#!/usr/bin/env bash
# Compares what `digests` prints with the table. usage: compare.sh usual|flush COMMAND...
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
mode=$1
shift
arguments=()
[[ $mode == usual ]] || arguments=(flush)
seen=$("$@" "${arguments[@]}") || exit $?
filter=(cat)
[[ $mode == usual ]] || filter=(grep ', exact, ')
if ! difference=$(diff <("${filter[@]}" <"$here/digests.txt") <("${filter[@]}" <<<"$seen" | tr -d '\r')); then
  printf 'other bits than tests/bits/digests.txt (group, table <, here >):\n%s\n' "$difference"
  exit 1
fi
tail -n 1 <<<"$seen"
