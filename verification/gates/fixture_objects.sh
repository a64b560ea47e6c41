#!/usr/bin/env bash
# fixture_objects.sh SOURCES MADE: compiles SOURCES/<room>.cpp to MADE/data/objects and, not optimised, to objects_plain.
# A room without a source gets an object with one function of its own.
set -euo pipefail
sources=$1
made=$2
mkdir -p "$made/tree"
for room in channel_a channel_b safety_core_comparator safety_core_kernel safety_core_selftest safety_core_crosslink hal_api; do
    source=$made/$room.cpp
    if [ -e "$sources/$room.cpp" ]; then
        cp "$sources/$room.cpp" "$source"
    else
        printf 'namespace counterpoint { int Of_%s(int x) { return x + 1; } }\n' "$room" >"$source"
    fi
    for kind in objects:-O2 objects_plain:-O0; do
        mkdir -p "$made/data/${kind%%:*}/$room"
        g++-12 -std=c++17 "${kind##*:}" -c "$source" -o "$made/data/${kind%%:*}/$room/$room.o"
    done
done
