#!/usr/bin/env bash
# fixture_tree.sh MADE FILE EXPRESSION: the tree of the near miss with one file changed by sed; a change that changes nothing is refused.
set -euo pipefail
mkdir -p "$1/tree"
cp -r "$(dirname "${BASH_SOURCE[0]}")/fixture/near_miss/tree/." "$1/tree"
sed -i -e "$3" "$1/tree/$2"
! cmp -s "$1/tree/$2" "$(dirname "${BASH_SOURCE[0]}")/fixture/near_miss/tree/$2"
