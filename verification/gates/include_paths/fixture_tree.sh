#!/usr/bin/env bash
# fixture_tree.sh MADE OPTION: the headers of all rooms in MADE/tree, and compile commands that all carry OPTION.
set -euo pipefail
made=$1
for room in safety_core/contract safety_core/comparator safety_core/kernel channel_a channel_b hal/api simulator/world; do
    mkdir -p "$made/tree/$room"
    printf 'struct Of_%s;\n' "${room//\//_}" >"$made/tree/$room/a.hpp"
done
mkdir -p "$made/data"
{
    printf '[\n'
    separator=
    for room in safety_core/comparator safety_core/kernel channel_a channel_b hal/api; do
        printf '%s{"directory": "%s", "command": "g++-12 %s -c a.cpp", "file": "%s/tree/%s/a.cpp"}\n' \
            "$separator" "$made" "$2" "$made" "$room"
        separator=,
    done
    printf ']\n'
} >"$made/data/compile_commands.json"
