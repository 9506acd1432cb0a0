#!/bin/bash
# A campaign in shards by GNU parallel, one thread each, joined at the end into campaign.json. All files are in the
# current folder.
#
#   tools/cluster/campaign_parallel.sh SHARDS [options of graze campaign]
#
# Stopped (Ctrl-C) and started again, it continues from the shards' part<i>.json. GNU parallel reads more options from
# the variable PARALLEL, such as --jobs 8, or --sshloginfile hosts.txt for other machines that see this folder.
#
# GRAZE: the command, if it is not on the path.
set -euo pipefail

if [[ ! "${1:-}" =~ ^[1-9][0-9]*$ ]]; then
  echo "campaign_parallel.sh: the first argument is the number of shards, 1 or more" >&2
  exit 2
fi
shards=$1
shift
graze=${GRAZE:-graze}

# A cast that failed makes its shard exit with 1: the others run on, and the merge says what failed. One signal asks a
# shard to finish its blocks, and a minute is ample.
status=0
parallel --line-buffer --workdir "$PWD" --termseq TERM,60000,KILL,25 \
  "$graze" campaign --shard "{}/$shards" --threads 1 --state "part{}.json" "${@@Q}" ">part{}.txt" \
  ::: $(seq "$shards") || status=$?
if ((status > 100)); then
  echo "campaign_parallel.sh: stopped; the same command continues" >&2
  exit 2
fi

mapfile -t parts < <(seq -f "part%.0f.json" "$shards")
exec "$graze" merge "${parts[@]}" --json campaign.json --save failures.jsonl
