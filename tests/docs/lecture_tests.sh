#!/usr/bin/env bash
# Every test that docs/explanation/lecture.md names exists, in the file that it names last before. usage: lecture_tests.sh SOURCE_DIR
set -euo pipefail
cd "$1"
file="" tests=0 missing=0
while read -r name; do
  if [[ $name == */* ]]; then
    file=$name
    [[ -f $file ]] || { echo "docs/explanation/lecture.md names $file, which does not exist"; missing=1; }
  else
    ((++tests))
    suite=${name%.*} test=${name#*.}
    [[ -f $file ]] && grep -qE "^(TEST|TEST_F|TEST_P|TYPED_TEST)\($suite, $test\)" "$file" ||
      { echo "docs/explanation/lecture.md names $name, which is not in $file"; missing=1; }
  fi
done < <(grep -oE '`((tests|bench|corpus)/[a-z_/]+\.[a-z]+|[A-Z][A-Za-z]+\.[A-Z][A-Za-z]+)`' docs/explanation/lecture.md | tr -d '`')
((tests >= 20)) || { echo "docs/explanation/lecture.md names $tests tests only: was it read?"; exit 1; }
((!missing)) && echo "$tests tests named, all there"
