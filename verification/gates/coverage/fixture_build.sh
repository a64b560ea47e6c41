#!/usr/bin/env bash
# fixture_build.sh CASE MADE: builds tree/ of a coverage fixture the way preset coverage does, and measures it.
set -euo pipefail
case_folder=$1
made=$2
cp -r verification/gates/coverage/common_tree "$made/tree"
cp -r "$case_folder/tree/." "$made/tree/"
cmake -G Ninja -S "$made/tree" -B "$made/build" -DCMAKE_CXX_COMPILER=clang++-19 -DCMAKE_EXPORT_COMPILE_COMMANDS=ON \
    -DCMAKE_CXX_FLAGS="-O0 -g -fprofile-instr-generate -fcoverage-mapping -fcoverage-mcdc -fprofile-update=atomic"
cmake --build "$made/build" --parallel 1
python3 verification/coverage/measure.py "$made/build" "$made/data/coverage" --root "$made/tree" --jobs 1 --all-tests
