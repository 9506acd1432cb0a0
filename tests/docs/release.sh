#!/usr/bin/env bash
# usage: release.sh SOURCE_DIR VERSION
# CHANGELOG.md begins with this version, CITATION.cff names it and its date, and the cases that the changelog names are in
# the corpus.
set -euo pipefail
cd "$1"
version=$2 failed=0
complain() { echo "$*"; failed=1; }
read -r _ newest _ day < <(grep -m 1 '^## ' CHANGELOG.md)
[[ $newest == "$version" ]] || complain "CHANGELOG.md begins with $newest, and the project is $version"
grep -qx "version: $version" CITATION.cff || complain "CITATION.cff names another version than $version"
grep -qx "date-released: $day" CITATION.cff || complain "CITATION.cff names another date than $day"
ids=$(tr '\n' ' ' <CHANGELOG.md | grep -oE '\[[a-z_]+/[^]]*\][^(]' | grep -oE '[a-z_]+/[a-z0-9_-]+' | sort -u)
(($(wc -w <<<"$ids") >= 10)) || complain "CHANGELOG.md names too few cases: was it read?"
for id in $ids; do
  grep -rqF "\"id\": \"$id\"" corpus/cases || complain "CHANGELOG.md names $id, which is not in corpus/cases"
done
((!failed)) && echo "version $version of $day, $(wc -w <<<"$ids") cases named"
