#!/usr/bin/env bash
# fixture_tree.sh MADE TARGET LIBRARIES: a package with one target and a consumer that links it.
set -euo pipefail
made=$1
config=$made/data/package/lib/cmake/Counterpoint
mkdir -p "$config" "$made/tree/tests/integration/package"
printf 'add_library(Counterpoint::%s INTERFACE IMPORTED)\nset_target_properties(Counterpoint::%s PROPERTIES INTERFACE_LINK_LIBRARIES "%s")\n' \
    "$2" "$2" "$3" >"$config/CounterpointConfig.cmake"
cat >"$made/tree/tests/integration/package/CMakeLists.txt" <<'TEXT'
cmake_minimum_required(VERSION 3.25)
project(Consumer LANGUAGES CXX)
find_package(Counterpoint REQUIRED)
add_executable(consumer main.cpp)
target_link_libraries(consumer PRIVATE Counterpoint::channel_a)
TEXT
echo 'int main() { return 0; }' >"$made/tree/tests/integration/package/main.cpp"
