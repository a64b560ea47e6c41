#!/usr/bin/env bash
# fixture_tree.sh MADE TARGET LIBRARIES [OUTPUT [FILE [CHANGE]]]: a package with one target and the manager's, a consumer of each,
# and a guide of one program that prints "output off". OUTPUT is what the guide says instead, FILE the text of its source file,
# CHANGE what the guide changes in the program so that it prints "output on".
set -euo pipefail
made=$1
config=$made/data/package/lib/cmake/Counterpoint
example=$made/tree/examples/first_device
manager=$made/data/package/include/canopen/manager
share=$made/data/package/share/counterpoint
mkdir -p "$made/data/package/bin" "$share"
printf '#!/bin/sh\ntest "$1" = demo || echo "$@"\n' >"$made/data/package/bin/counterpoint"
chmod 755 "$made/data/package/bin/counterpoint"
for text in man/man1/counterpoint.1 bash-completion/completions/counterpoint zsh/site-functions/_counterpoint fish/vendor_completions.d/counterpoint.fish; do
    mkdir -p "$made/data/package/share/${text%/*}"
    case $text in man/*) echo man ;; *) echo "completion ${text%%[-/]*}" ;; esac >"$made/data/package/share/$text"
done
echo Licence >"$share/LICENSE"
printf '# Guide\n[Licence](LICENSE)\n' >"$share/guide.md"
mkdir -p "$config" "$manager" "$made/tree/tests/integration/package" "$made/tree/docs" "$example"
printf 'add_library(Counterpoint::%s INTERFACE IMPORTED)\nset_target_properties(Counterpoint::%s PROPERTIES INTERFACE_LINK_LIBRARIES "%s")\n' \
    "$2" "$2" "$3" >"$config/CounterpointConfig.cmake"
printf 'add_library(Counterpoint::canopen_manager INTERFACE IMPORTED)\ntarget_include_directories(Counterpoint::canopen_manager INTERFACE %s)\n' \
    "$made/data/package/include" >>"$config/CounterpointConfig.cmake"
echo 'inline bool IsOperational() { return true; }' >"$manager/manager.hpp"
cat >"$made/tree/tests/integration/package/CMakeLists.txt" <<'TEXT'
cmake_minimum_required(VERSION 3.25)
project(Consumer LANGUAGES CXX)
find_package(Counterpoint REQUIRED)
add_executable(consumer main.cpp)
target_link_libraries(consumer PRIVATE Counterpoint::channel_a)
add_executable(manager_consumer manager.cpp)
target_link_libraries(manager_consumer PRIVATE Counterpoint::canopen_manager)
TEXT
echo 'int main() { return 0; }' >"$made/tree/tests/integration/package/main.cpp"
printf '#include "canopen/manager/manager.hpp"\nint main() { return IsOperational() ? 0 : 1; }\n' \
    >"$made/tree/tests/integration/package/manager.cpp"
cat >"$example/CMakeLists.txt" <<'TEXT'
cmake_minimum_required(VERSION 3.25)
project(FirstDevice LANGUAGES CXX)
add_executable(first_device main.cpp)
TEXT
program=$(printf '#include <cstdio>\nint main() { std::puts("output off"); }')
printf '%s\n' "$program" >"$example/main.cpp"
{
    printf '<!-- file: examples/first_device/CMakeLists.txt -->\n```cmake\n%s\n```\n' "$(cat "$example/CMakeLists.txt")"
    printf '<!-- file: examples/first_device/main.cpp -->\n```cpp\n%s\n```\n' "${5:-$program}"
    printf '<!-- output: build/first_device -->\n```\n%s\n```\n' "${4:-output off}"
    printf '<!-- changed: %s -->\n```\noutput on\n```\n' "${6:-main.cpp: off => on}"
} >"$made/tree/docs/user_guide.md"
