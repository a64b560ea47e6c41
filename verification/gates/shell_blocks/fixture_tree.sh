#!/usr/bin/env bash
# fixture_tree.sh MADE TARGET: a tree that installs two libraries, with a finished build of both, and a guide that builds TARGET.
set -euo pipefail
tree=$1/tree
mkdir -p "$tree/docs"
cat >"$tree/CMakeLists.txt" <<'TEXT'
cmake_minimum_required(VERSION 3.25)
project(Two LANGUAGES CXX)
add_library(first STATIC first.cpp)
add_library(second STATIC second.cpp)
add_custom_target(both DEPENDS first second)
install(TARGETS first second ARCHIVE DESTINATION lib)
TEXT
echo '{"version": 6, "configurePresets": [{"name": "product", "generator": "Ninja", "binaryDir": "${sourceDir}/build/product", "cacheVariables": {"CMAKE_CXX_COMPILER": "g++-12"}}]}' >"$tree/CMakePresets.json"
echo 'int First() { return 1; }' >"$tree/first.cpp"
echo 'int Second() { return 2; }' >"$tree/second.cpp"
cmake -S "$tree" --preset product
cmake --build "$tree/build/product"
printf '# Guide\n```sh\ncmake --preset product\ncmake --build build/product --target %s\ncmake --install build/product --prefix /opt/counterpoint\ntest -f /opt/counterpoint/lib/libsecond.a\n```\n' \
    "$2" >"$tree/docs/guide.md"
