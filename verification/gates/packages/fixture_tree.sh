#!/usr/bin/env bash
# fixture_tree.sh MADE: the least that can be handed out in each way: a program that prints "output off", and a library of nothing.
# Variables that a case sets: LIBRARY, TOOL (names of the packages), DOC (folder of the library's licence), SHARED (a file that
# both packages have), SUBPROJECT, PKG_FLAGS, CONAN (what their programs print, the flags, what the recipe prints), MORE (what else the
# project that takes the sources makes), BY_SUBDIRECTORY (what its program prints where it takes them by add_subdirectory).
set -euo pipefail
made=$1
tree=$made/tree
library=${LIBRARY:-libcounterpoint-dev}
tool=${TOOL:-counterpoint}
mkdir -p "$tree/docs" "$tree/examples/first_device" "$tree/tests/integration/subproject/first_device" "$made/data/debian"
touch "$made/data/this_machine"
echo 'project(Counterpoint VERSION 0.1.0)' >"$tree/CMakeLists.txt"
printf '<!-- output: build/first_device -->\n```\noutput off\n```\n' >"$tree/docs/user_guide.md"
printf '#include <cstdio>\nint main() { std::puts("output off"); }\n' >"$tree/examples/first_device/main.cpp"
cat >"$tree/examples/first_device/CMakeLists.txt" <<'TEXT'
cmake_minimum_required(VERSION 3.25)
project(FirstDevice LANGUAGES CXX)
add_executable(first_device main.cpp)
TEXT
printf 'cmake_minimum_required(VERSION 3.25)\nproject(Fetched LANGUAGES CXX)\nadd_subdirectory(first_device)\n' \
    >"$tree/tests/integration/subproject/CMakeLists.txt"
cat >"$tree/tests/integration/subproject/first_device/CMakeLists.txt" <<TEXT
set(SAYS "${SUBPROJECT:-output off}")
if(COUNTERPOINT_WAY STREQUAL "add_subdirectory")
  set(SAYS "${BY_SUBDIRECTORY:-${SUBPROJECT:-output off}}")
endif()
file(WRITE \${CMAKE_CURRENT_BINARY_DIR}/main.cpp "#include <cstdio>\nint main() { std::puts(\"\${SAYS}\"); }\n")
file(WRITE \${CMAKE_CURRENT_BINARY_DIR}/used.cpp "int used();\nint used() { return 1; }\n")
add_library(used STATIC \${CMAKE_CURRENT_BINARY_DIR}/used.cpp)
add_executable(first_device \${CMAKE_CURRENT_BINARY_DIR}/main.cpp)
target_link_libraries(first_device PRIVATE used)
${MORE:-}
TEXT
cat >"$tree/conanfile.py" <<TEXT
from conan import ConanFile


class Fixture(ConanFile):
    name = "counterpoint"
    version = "0.1.0"

    def package(self):
        self.output.info("packaged")
        print("${CONAN:-output off}")
TEXT

# deb NAME FILE...: a package with these files, made in the folder of its name.
deb()
{
    mkdir -p "$made/$1/DEBIAN"
    printf 'Package: %s\nVersion: 0.1.0\nArchitecture: all\nMaintainer: nobody <nobody@example.invalid>\nDescription: fixture\n' "$1" \
        >"$made/$1/DEBIAN/control"
    dpkg-deb --build "$made/$1" "$made/data/debian" >/dev/null
}

mkdir -p "$made/$library/usr/lib/pkgconfig" "$made/$library/usr/share/doc/${DOC:-$library}" "$made/$tool/usr/bin" "$made/$tool/usr/share/doc/$tool"
printf 'Name: counterpoint\nDescription: fixture\nVersion: 0.1.0\nLibs: %s\n' "${PKG_FLAGS:-}" >"$made/$library/usr/lib/pkgconfig/counterpoint.pc"
echo Licence | tee "$made/$library/usr/share/doc/${DOC:-$library}/copyright" >"$made/$tool/usr/share/doc/$tool/copyright"
printf '#!/bin/sh\necho "counterpoint %s (commit unknown)"\n' "${VERSION:-0.1.0}" >"$made/$tool/usr/bin/counterpoint"
chmod 755 "$made/$tool/usr/bin/counterpoint"
if [ -n "${SHARED:-}" ]; then
    touch "$made/$library/usr/$SHARED" "$made/$tool/usr/$SHARED"
fi
deb "$library"
deb "$tool"
