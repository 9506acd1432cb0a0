#!/usr/bin/env bash
# The hosted workflows follow their schema. npm fetches the validator. usage: workflows.sh SOURCE_DIR
set -euo pipefail
command -v npx >/dev/null || { echo "no npx: skipped"; exit 77; }
for file in "$1"/.github/workflows/*.yml; do
  npx --yes --package @action-validator/cli@0.6.0 --package @action-validator/core@0.6.0 action-validator "$file"
done
echo "the workflows follow their schema"
