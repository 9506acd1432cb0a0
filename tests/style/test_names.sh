#!/usr/bin/env bash
# The names of tests are PascalCase sentences: Subject.SaysWhatHolds. usage: test_names.sh SOURCE_DIR
set -euo pipefail
cd "$1"
tests='^ *(TEST|TEST_F|TEST_P|TYPED_TEST|TYPED_TEST_P)\('
count=$(grep -rhcE "$tests" tests --include='*_test.cpp' | awk "{ n += \$1 } END { print n }")
((count > 1000)) || { echo "found only $count tests: wrong folder?"; exit 1; }
if grep -rnE "$tests" tests --include='*.cpp' --include='*.hpp' | grep -vE '\([A-Z][A-Za-z0-9]*, [A-Z][A-Za-z0-9]*\)'; then
  echo "these tests are not named by PascalCase sentences"
  exit 1
fi
echo "$count tests are named by PascalCase sentences"
