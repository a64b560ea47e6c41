#!/usr/bin/env bash
# fixture_tree.sh MADE: a tree of one header and one document. A case sets COMMENT (of the function's parameter) or LINK.
set -euo pipefail
tree=$1/tree
mkdir -p "$tree/tools/reference" "$tree/safety_core" "$tree/docs" "$1/data"
for folder in hal/api hal/absent hal/contract_test canopen/cia301 canopen/cia302 canopen/cia305 canopen/start_up canopen/manager canopen/device canopen/generated version; do
    mkdir -p "$tree/$folder"
done
cp tools/reference/* "$tree/tools/reference"
echo 'project(Counterpoint VERSION 0.1.0)' >"$tree/CMakeLists.txt"
printf '# Counterpoint\nSee [the rule](docs/guide.md#%s).\n' "${LINK:-the-rule}" >"$tree/README.md"
printf '# Changes\n' >"$tree/CHANGELOG.md"
printf '# Guide\n## The rule\nIt holds.\n' >"$tree/docs/guide.md"
cat >"$tree/safety_core/door.hpp" <<TEXT
/// @file
/// A door.

/// @brief Opens it.
/// @param ${COMMENT:-width} in mm
void Open(int width);
TEXT
