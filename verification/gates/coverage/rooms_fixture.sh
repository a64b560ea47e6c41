#!/usr/bin/env bash
# rooms_fixture.sh CASE MADE: near_miss_recorded with the files of CASE on top, and what its measurement gave, without building it again.
set -euo pipefail
here=verification/gates/coverage
mkdir -p "$2/tree" "$2/data/coverage"
cp -r $here/common_tree/. "$2/tree/"
cp -r $here/fixture/near_miss_recorded/tree/. "$2/tree/"
cp -r "$1/tree/." "$2/tree/"
sed "s#@TREE@#$2/tree#g" $here/rooms_export.json >"$2/data/coverage/export.json"
